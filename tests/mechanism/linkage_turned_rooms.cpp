// Boxes that are turned so that their width, or their area, is least: against closed forms, all directions of a fine
// scan and differences.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "analysis/geometry/separation.h"
#include "analysis/numbers/golden_section.h"
#include "synthesis/problem/linkage/of_kinds/expand.h"
#include "synthesis/report/drawing/scene.h"
#include "synthesis/solve/solve.h"
#include "tests/long_form.h"
#include "tests/mechanism/kinds_with_rooms.h"

namespace mechwright::linkage_scans {

namespace {

std::string turned_room(const std::string& name, const std::string& direction, const std::string& of = {}) {
    return "[[room]]\nname = \"" + name + "\"\ndirection = \"" + direction + "\"\n" +
           (of.empty() ? "" : "of = [" + of + "]\n");
}

/// A point of a trammel's bar is on an ellipse of half axes 10 and 30, turned by 40 deg.
TEST(TurnedRooms, OfAnEllipseHaveItsAxes) {
    const std::string text =
        "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { O = [0, 0] }\nbar = { A = [0, 0], B = [10, 0], P = "
        "[15, 0] }\n[[slot]]\npin = \"A\"\nin = \"frame\"\npoint = \"O\"\ndirection = 0\n[[slot]]\npin = \"B\"\nin = "
        "\"frame\"\npoint = \"O\"\ndirection = 90\n[drive]\nlink = \"bar\"\n[placement]\nscale = 2\ntilt = 40\n" +
        turned_room("thin", "least-width", "\"P\"") + turned_room("small", "least-area", "\"P\"");
    const Json document = analysed_room(text).document;
    EXPECT_NEAR(value_in(document, "thin.width"), 20, 1e-12);
    EXPECT_NEAR(value_in(document, "small.area"), 1200, 1e-10);
    expect_verified(document);
}

/// The pin of a crank of 10 that swings by 120 deg: one side of the box is the chord of its arc.
TEST(TurnedRooms, OfAnArcLieAlongItsChord) {
    const std::string text =
        "schema = 1\nmechanism = \"linkage\"\n[dimensions]\narm = 10\n[links]\nframe = { A = [0, 0] }\ncrank = { A = "
        "[0, 0], B = [\"arm\", 0] }\n[drive]\nlink = \"crank\"\n[motion]\ncrank_range = [-40, 80]\n" +
        turned_room("thin", "least-width", "\"B\"") + turned_room("small", "least-area", "\"B\"");
    const Json document = analysed_room(text).document;
    const double chord = 20 * std::sin(60 * one_degree);
    EXPECT_NEAR(value_in(document, "thin.width"), 5, 1e-12);
    EXPECT_NEAR(value_in(document, "small.area"), 5 * chord, 1e-11);
    expect_verified(document);
    expect_room_slopes(text, {"thin.width", "small.area"});
}

/// One side touches a point 2.8e-9 rad beside the limit at which the dyad folds, 2e-8 farther out than the limit
/// itself: area by places in forty digits, each found along the root of the way from the limit.
TEST(TurnedRooms, TouchPlacesCloseToWhereAMotionEnds) {
    const Json document =
        analysed_room(
            "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 2.477\ncrank = 2.211\n"
            "coupler = 3.502\nrocker = 1.555\npoint-along = 3.183\npoint-across = -4.17\nassembly = \"open\"\n" +
            turned_room("box", "least-area", "\"P\", \"C\""))
            .document;
    EXPECT_NEAR(value_in(document, "box.area"), 32.99791626893, 1e-9);
    expect_verified(document);
}

TEST(TurnedRooms, OfWhatIsAsWideInAllDirectionsAreOne) {
    const Json document = analysed_room(kinds_with_rooms[0].text() + turned_room("orbit", "least-width", "\"B\"") +
                                        turned_room("square", "least-area", "\"B\"") +
                                        turned_room("pivots", "least-width", "\"A\", \"D\"") +
                                        turned_room("pivot", "least-area", "\"A\""))
                              .document;
    EXPECT_NEAR(value_in(document, "orbit.width"), 4, 1e-13);
    EXPECT_NEAR(value_in(document, "square.area"), 16, 1e-12);
    EXPECT_NEAR(value_in(document, "pivots.width"), 0, 1e-14);
    EXPECT_NEAR(value_in(document, "pivot.area"), 0, 1e-14);
    expect_verified(document);
}

/// Width and area of the least boxes about all places, by all directions.
std::pair<double, double> least_of_directions(const std::vector<Vector<double>>& places) {
    std::vector<Vector<double>> corners;
    for (const std::size_t i : convex_hull(places))
        corners.push_back(places[i]);
    const auto width = [&](double degrees) {
        double low = 1e99, high = -1e99;
        for (const Vector<double>& at : corners) {
            low = std::min(low, along_way(at, degrees));
            high = std::max(high, along_way(at, degrees));
        }
        return high - low;
    };
    const auto area = [&](double degrees) { return width(degrees) * width(degrees + 90); };
    const auto least = [](const auto& of) {
        constexpr int directions = 1440;
        double best = 1e99;
        for (int i = 0; i < directions; ++i)
            best = std::min(best, of(180. * i / directions));
        double found = best;
        for (int i = 0; i < directions; ++i) {
            const double at = 180. * i / directions, step = 180. / directions;
            if (of(at) > of(at - step) || of(at) > of(at + step)) continue;
            const double lowest = greatest_between([&](double d) { return -of(d); }, at - step, at + step, 60);
            found = std::min(found, of(lowest));
        }
        return found;
    };
    return {least(width), least(area)};
}

TEST(TurnedRooms, AreTheLeastOfAllDirections) {
    for (const KindWithRooms& of : kinds_with_rooms) {
        SCOPED_TRACE(of.kind);
        const std::string rooms = turned_room("thin", "least-width") + turned_room("small", "least-area");
        const AnalysedRoom found = analysed_room(of.text() + rooms);
        std::vector<Vector<double>> places;
        for (const Places& pose : poses_of(found.design, 6000))
            places.insert(places.end(), pose.begin(), pose.end());
        const auto [width, area] = least_of_directions(places);
        EXPECT_NEAR(value_in(found.document, "thin.width"), width, 1e-5 * width);
        EXPECT_NEAR(value_in(found.document, "small.area"), area, 1e-5 * area);
        expect_verified(found.document);
        const ExpandedProblem expanded = expand_problem(of.text() + rooms, "kind.toml");
        ASSERT_TRUE(expanded.ok());
        const Json linkage = analysed_room(expanded.text).document;
        for (const char* size : {"thin.width", "small.area"})
            EXPECT_NEAR(value_in(linkage, size), value_in(found.document, size), 1e-11 * area) << size;
    }
}

/// Except in the long form of the area of one kind, and of the width of what one point of another needs.
TEST(TurnedRooms, HaveExactDerivatives) {
    for (const KindWithRooms& of : kinds_with_rooms) {
        SCOPED_TRACE(of.kind);
        std::vector<std::string> sizes{"thin.width", "small.area"};
        if (!in_long_form()) {
            if (of.kind != "drag-link") continue;
            sizes = {"small.area"};
        }
        expect_room_slopes(of.text() + turned_room("thin", "least-width") + turned_room("small", "least-area"), sizes);
    }
    expect_room_slopes(
        kinds_with_rooms[0].text() + turned_room("path", "least-width", "\"P\"") +
            turned_room("about", "least-area", "\"P\""),
        in_long_form() ? std::vector<std::string>{"path.width", "about.area"} : std::vector<std::string>{"path.width"});
}

/// A lift whose feet and rollers stay above each other: both sides of its box lie on two places, as far apart
/// as the foot goes.
TEST(TurnedRooms, HaveExactDerivativesWhereBothSidesLieOnTwoPlaces) {
    std::ifstream in(MECHWRIGHT_SOURCE_DIR "/problems/linkage/scissors-ram.toml");
    const std::string text = std::string{std::istreambuf_iterator<char>(in), {}} +
                             "[motion]\ncrank_range = [300, 900]\n" + turned_room("thin", "least-width");
    EXPECT_NEAR(value_in(analysed_room(text).document, "thin.width"), 900, 1e-10);
    expect_room_slopes(text, {"thin.width"});
    // The rollers go straight along one side: rounding must not decide what touches it. No arm changes the width.
    const ReadProblem read = testing::read_without_fault(text);
    const Mechanism& m = *read.problem.mechanism;
    const Quantity& width = m.quantities[static_cast<std::size_t>(find_quantity(m, "thin.width"))];
    Motion motion = finished_design(read.problem, evaluate_given(read.problem).design).motion;
    motion.model = m.model.data();
    motion.of = width.of.data();
    std::vector<double> arguments;
    for (const DimensionRange& range : read.problem.dimensions)
        arguments.push_back(range.start.value_or(range.min));
    std::vector<double> value(width.components(motion)), gradient(value.size() * arguments.size());
    for (int i = 0; i < cases_to_try(24, 200); ++i) {
        arguments[0] = 1000 + 1e-6 * i;
        width.measure(motion, arguments, {value, gradient, {}});
        EXPECT_NEAR(gradient[0], 0, 1e-9) << i;
    }
}

TEST(TurnedRooms, AreVerifiedOverMotionsThatEnd) {
    for (const char* motion : {"", "[motion]\ncrank_range = [-35, 110]\n"}) {
        const Json document =
            analysed_room(rocking_room + motion + turned_room("thin", "least-width") +
                          turned_room("small", "least-area") + turned_room("path", "least-area", "\"P\""))
                .document;
        expect_verified(document);
        if (in_long_form())
            expect_refused_if_off(document, {"thin.width", "small.area", "path.area"});
        else
            expect_refused_if_off(document, {*motion == 0 ? "small.area" : "thin.width"});
        if (*motion == 0 && !in_long_form()) continue;
        Json changed = document;
        changed["linkage"]["room"][1]["direction"] = "least-width";
        EXPECT_TRUE(is_refused(changed));
    }
}

/// Places that are farthest next to a singular end, by a search of directions in steps that go down to 1e-11 degrees.
TEST(TurnedRooms, AreExactNextToSingularEnds) {
    const auto with = [](const std::string& dimensions) {
        return analysed_room("schema = 1\nmechanism = \"four-bar\"\n[dimensions]\n" + dimensions +
                             turned_room("small", "least-area", "\"P\", \"C\""))
            .document;
    };
    const Json one = with(
        "ground = 1.108\ncrank = 1.05\ncoupler = 4.754\nrocker = 2.796\npoint-along = 0.688\n"
        "point-across = 3.591\n");
    EXPECT_NEAR(value_in(one, "small.area"), 20.0191762, 2e-7);
    expect_verified(one);
    const Json other = with(
        "ground = 3.819\ncrank = 1.516\ncoupler = 3.939\nrocker = 1.025\npoint-along = -2.565\n"
        "point-across = 2.743\n");
    EXPECT_NEAR(value_in(other, "small.area"), 15.577560441, 1e-9);
    expect_verified(other);
}

/// Three more in the long form.
TEST(TurnedRooms, AreOfDrivesOfAllSorts) {
    std::vector<const char*> files{"pick-and-place", "tipping-cylinder"};
    if (in_long_form()) files.insert(files.end(), {"platform-swing", "scissors-ram", "jansen-leg"});
    for (const char* file : files) {
        SCOPED_TRACE(file);
        std::ifstream in(MECHWRIGHT_SOURCE_DIR "/problems/linkage/" + std::string(file) + ".toml");
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        const Json document =
            analysed_room(text + turned_room("thin", "least-width") + turned_room("small", "least-area")).document;
        EXPECT_GT(value_in(document, "thin.width"), 0);
        EXPECT_GE(count_of_stated(document), 1u);
    }
}

TEST(TurnedRooms, AreDrawnAsTheyAre) {
    const AnalysedRoom found = analysed_room(kinds_with_rooms[0].text() + turned_room("thin", "least-width"));
    const Scene scene = scene_of(found.design, 1e-4);
    std::size_t count = 0;
    for (const Outline& outline : scene.fixed) {
        if (outline.layer != Layer::room) continue;
        ++count;
        ASSERT_EQ(outline.vertices.size(), 4u);
        const Vector<double> width = outline.vertices[1].at - outline.vertices[0].at;
        EXPECT_NEAR(std::hypot(width.x, width.y), value_in(found.document, "thin.width"), 1e-12);
    }
    EXPECT_EQ(count, 1u);
}

TEST(TurnedRooms, SayWhatIsWrong) {
    const auto expect_error = [&](const std::string& part, const std::string& has) {
        const std::string error = testing::first_error(rocking_room + part);
        EXPECT_NE(error.find(has), std::string::npos) << error;
    };
    expect_error(turned_room("thin", "best"),
                 "'direction' in [[room]] number 1 must be an angle, \"least-width\" or \"least-area\", not a string");
    expect_error(
        turned_room("thin", "least-width") + "[[require]]\nquantity = \"thin.height\"\nmax = 3\n",
        "'thin.height' is no quantity of a room that is turned to its least width: write 'thin.width', or give "
        "its 'direction' as an angle");
}

/// A four-bar whose coupler point goes through three places, in the thinnest box.
TEST(TurnedRooms, AreMadeLeast) {
    const std::string text =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = { min = 4, max = 6, start = 5 "
        "}\ncrank = 2\ncoupler = { min = 4, max = 6, start = 5 }\nrocker = { min = 3, max = 6, start = 4 "
        "}\npoint-along = 2.5\npoint-across = 3\n" +
        turned_room("path", "least-width", "\"P\"") +
        "[[require]]\nquantity = \"transmission-angle-worst\"\nmin = 40\n[objective]\nminimize = "
        "\"path.width\"\n[solver]\nstarts = 3\n";
    const ReadProblem read = testing::read_without_fault(text);
    ASSERT_TRUE(read.ok());
    const Json document = mechwright::document(read.problem, solve(read.problem, {}));
    EXPECT_EQ(document["status"], "solved");
    EXPECT_LT(value_in(document, "path.width"), 2);
    expect_verified(document);
}

}  // namespace

}  // namespace mechwright::linkage_scans
