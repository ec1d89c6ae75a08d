// Curvatures of points' paths: against ellipses in closed form, circles through three places of a scan, and
// differences; where there is none; in the words of files and results.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "synthesis/report/text/summary.h"
#include "synthesis/solve/solve.h"
#include "tests/long_form.h"
#include "tests/mechanism/kinds_with_rooms.h"

namespace mechwright::linkage_scans {

namespace {

std::string with_any_value(const std::vector<std::string>& quantities) {
    std::string text;
    for (const std::string& one : quantities)
        text += "[[require]]\nquantity = \"" + one + "\"\nmin = -1e9\n";
    return text;
}

/// A bar of 10 with its ends in slots along the axes. A point `pen` from the one in the x axis is on an ellipse, at
/// ((pen - 10) cos t, pen sin t).
std::string trammel(const std::string& pen, const std::string& more) {
    return "schema = 1\nmechanism = \"linkage\"\n[dimensions]\npen = " + pen +
           "\n[links]\nframe = { O = [0, 0] }\nbar = { A = [0, 0], B = [10, 0], P = [\"pen\", 0] }\n"
           "[[slot]]\npin = \"A\"\nin = \"frame\"\npoint = \"O\"\ndirection = 0\n"
           "[[slot]]\npin = \"B\"\nin = \"frame\"\npoint = \"O\"\ndirection = 90\n"
           "[signals]\nbend = { curvature-of = \"P\" }\n" +
           more;
}

/// Curvature of the ellipse (a cos t, b sin t), passed as t grows, and its derivative by t.
struct OfEllipse {
    double a, b;

    double square(double t) const { return std::pow(a * std::sin(t), 2) + std::pow(b * std::cos(t), 2); }
    double curvature(double t) const { return a * b / std::pow(square(t), 1.5); }
    double slope(double t) const { return -1.5 * a * b * (a * a - b * b) * std::sin(2 * t) / std::pow(square(t), 2.5); }
};

void expect_has(const Json& document, const std::vector<std::pair<std::string, double>>& known) {
    for (const auto& [name, value] : known)
        EXPECT_NEAR(value_in(document, name), value, 1e-12 * (1 + std::abs(value))) << name;
}

TEST(LinkageCurvatures, AreThoseOfEllipses) {
    const std::vector<std::string> asked{"bend.at(25)", "bend.speed.at(25)", "bend.deviation", "bend.least(30, 60)"};
    const std::string drive = "[drive]\nlink = \"bar\"\nspeed = 30\n[placement]\nscale = 2\ntilt = 40\n";
    for (const double pen : {15.0, 3.0}) {
        const Json document = analysed_room(trammel(std::to_string(pen), drive + with_any_value(asked))).document;
        const OfEllipse path{2 * (pen - 10), 2 * pen};
        const double one = path.curvature(0), other = path.curvature(90 * one_degree);
        expect_has(document, {{"bend.least", std::min(one, other)},
                              {"bend.greatest", std::max(one, other)},
                              {"bend.deviation", std::abs(one - other) / 2},
                              {"bend.at(25)", path.curvature(25 * one_degree)},
                              {"bend.speed.at(25)", std::numbers::pi * path.slope(25 * one_degree)},
                              {"bend.least(30, 60)",
                               std::min(path.curvature(30 * one_degree), path.curvature(60 * one_degree))}});
        expect_verified(document);
        Json changed = document;
        changed["quantities"]["bend.greatest"] = value_in(document, "bend.greatest") * (1 + 1e-7);
        EXPECT_TRUE(is_refused(changed));
        changed = document;
        changed["signals"]["bend"]["curvature-of"] = "B";
        EXPECT_TRUE(is_refused(changed));
    }
}

/// Driven by the end in the x axis, whose displacement is -10 cos t.
TEST(LinkageCurvatures, AreByLengthsWhereASlideDrives) {
    const std::string text =
        "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { O = [0, 0] }\nfoot = { A = [0, 0] }\n"
        "bar = { A = [0, 0], B = [10, 0], P = [15, 0] }\n[[slide]]\nname = \"bed\"\nlink = \"foot\"\non = \"frame\"\n"
        "point = \"O\"\ndirection = 0\n[[slot]]\npin = \"B\"\nin = \"frame\"\npoint = \"O\"\ndirection = 90\n[drive]\n"
        "slide = \"bed\"\n[motion]\ncrank_range = [-8, 6]\n[signals]\nbend = { curvature-of = \"P\" }\n" +
        with_any_value({"bend.at(-4)", "bend.speed.at(-4)"});
    const Json document = analysed_room(text).document;
    const OfEllipse path{5, 15};
    const double t = std::acos(0.4);
    expect_has(document, {{"bend.greatest", path.curvature(std::numbers::pi / 2)},
                          {"bend.least", path.curvature(std::acos(0.8))},
                          {"bend.at(-4)", path.curvature(t)},
                          {"bend.speed.at(-4)", path.slope(t) / (10 * std::sin(t))}});
    expect_verified(document);
}

/// Of the circle through three places, against the clock.
double through_three(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c) {
    const Vector<double> one = b - a, other = c - b, both = c - a;
    return 2 * cross(one, other) / std::sqrt(dot(one, one) * dot(other, other) * dot(both, both));
}

TEST(LinkageCurvatures, AreThoseOfCirclesThroughThreePlaces) {
    constexpr int steps = 20000;
    for (const std::size_t kind : {0, 1}) {
        SCOPED_TRACE(kinds_with_rooms[kind].kind);
        const std::string signals =
            "[signals]\nbend = { curvature-of = \"P\" }\nlow = { y = \"P\" }\nboth = { ratio = "
            "[\"low\", \"bend\"] }\nturned = { sum = { bend = -2 } }\n";
        const AnalysedRoom found = analysed_room(
            kinds_with_rooms[kind].text() + signals +
            with_any_value({"bend.rms", "bend.mean(300, 40)", "bend.jerk.greatest(30, 80)", "turned.greatest"}));
        const std::vector<Places> poses = poses_of(found.design, steps);
        ASSERT_EQ(poses.size(), steps + 1u);
        const std::size_t point = points_of(found.design).size() - 1;
        double least = 1e9, greatest = -1e9;
        for (std::size_t i = 0; i + 2 < poses.size(); ++i) {
            const double one = through_three(poses[i][point], poses[i + 1][point], poses[i + 2][point]);
            least = std::min(least, one);
            greatest = std::max(greatest, one);
        }
        // What lies between steps goes like the square of one.
        const double near = 1e-5 * (1 + std::abs(least));
        EXPECT_NEAR(value_in(found.document, "bend.least"), least, near);
        EXPECT_NEAR(value_in(found.document, "bend.greatest"), greatest, near);
        EXPECT_NEAR(value_in(found.document, "turned.greatest"), -2 * least, 2 * near);
        expect_verified(found.document);
    }
}

TEST(LinkageCurvatures, HaveExactDerivatives) {
    const std::vector<std::string> names{"bend.least", "bend.greatest(40, 90)", "bend.at(70)", "bend.speed.at(200)"};
    for (const std::size_t kind : {0, 1}) {
        SCOPED_TRACE(kinds_with_rooms[kind].kind);
        expect_room_slopes(
            kinds_with_rooms[kind].text() + "[signals]\nbend = { curvature-of = \"P\" }\n" + with_any_value(names),
            names);
    }
}

/// Hoecken's curve is nearly straight, and straight in places: a radius has poles there, a curvature passes zero.
TEST(LinkageCurvatures, PassZeroWhereAPathIsStraight) {
    const std::string text =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 2\ncrank = 1\ncoupler = 2.5\nrocker = "
        "2.5\npoint-along = 5\npoint-across = 0\n[signals]\nbend = { "
        "curvature-of = \"P\" }\n" +
        with_any_value({"bend.rms", "bend.range"});
    const Json document = analysed_room(text).document;
    EXPECT_LT(value_in(document, "bend.least"), -0.01);
    EXPECT_GT(value_in(document, "bend.greatest"), 0.01);
    expect_verified(document);
}

/// The rocker's pin is on a circle of the rocker's length, and comes to rest in two dead centres.
TEST(LinkageCurvatures, HaveNoValueWhereThePointRests) {
    const std::string text = kinds_with_rooms[0].text() + "[signals]\npin = { curvature-of = \"C\" }\nfixed = { " +
                             "curvature-of = \"D\" }\norbit = { curvature-of = \"B\" }\n";
    const Json document = analysed_room(text + with_any_value({"orbit.mean", "pin.greatest(150, 300)"})).document;
    for (const char* name : {"pin.least", "pin.greatest", "fixed.least"})
        EXPECT_FALSE(document["quantities"].contains(name)) << name;
    expect_has(document, {{"orbit.least", 0.5}, {"orbit.greatest", 0.5}, {"orbit.mean", 0.5}});
    EXPECT_NEAR(std::abs(value_in(document, "pin.greatest(150, 300)")), 0.25, 1e-12);
    expect_verified(document);
    for (const char* quantity : {"pin.mean", "pin.rms", "pin.speed.greatest", "fixed.at(20)"}) {
        const ReadProblem read = parse_problem(text + with_any_value({quantity}), "rests.toml");
        ASSERT_TRUE(read.ok());
        const Json found = mechwright::document(read.problem, solve(read.problem, {}));
        EXPECT_EQ(found["status"], "infeasible") << quantity;
        EXPECT_FALSE(found["quantities"].contains(quantity));
    }
}

/// A point of the coupler that is its instant centre somewhere has a cusp there.
TEST(LinkageCurvatures, HaveNoValueAtACusp) {
    const double angle = 60 * one_degree;
    const Vector<double> b{2 * std::cos(angle), 2 * std::sin(angle)}, d{5, 0}, way = d - b;
    const double distance = std::hypot(way.x, way.y), along = (4.5 * 4.5 - 16 + distance * distance) / (2 * distance),
                 across = std::sqrt(4.5 * 4.5 - along * along);
    const Vector<double> c = b + (along / distance) * way + (across / distance) * left_of(way);
    // The lines of crank and rocker meet in it.
    const Vector<double> arm = c - d;
    const double far = cross(d, arm) / cross(b, arm);
    const Vector<double> centre = far * b, from_b = centre - b, coupler = (1 / 4.5) * (c - b);
    const auto number = [](double x) { return Json(x).dump(); };
    const std::string text =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 5\ncrank = 2\ncoupler = "
        "4.5\nrocker = 4\npoint-along = " +
        number(dot(coupler, from_b)) + "\npoint-across = " + number(cross(coupler, from_b)) +
        "\n[signals]\nbend = { curvature-of = \"P\" }\nfast = { speed-of = \"P\" }\n";
    const Json document = analysed_room(text + with_any_value({"bend.greatest(80, 20)"})).document;
    EXPECT_NEAR(value_in(document, "fast.least"), 0, 1e-12);
    EXPECT_FALSE(document["quantities"].contains("bend.greatest"));
    EXPECT_GT(value_in(document, "bend.greatest(80, 20)"), 0);
    expect_verified(document);
}

/// Towards a singular end of a motion points become infinitely fast; cranks do not.
TEST(LinkageCurvatures, AreNotStatedAtSingularEnds) {
    const std::string text =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 5\ncrank = 3.5\ncoupler = 2.8\nrocker = "
        "2.9\npoint-along = -1.7\npoint-across = -0.5\n[signals]\nbend = { curvature-of = \"P\" }\norbit = { "
        "curvature-of = \"B\" }\n";
    const Json document = analysed_room(text + with_any_value({"bend.greatest(-20, 20)"})).document;
    EXPECT_FALSE(document["quantities"].contains("bend.greatest"));
    EXPECT_TRUE(document["quantities"].contains("bend.greatest(-20, 20)"));
    expect_has(document, {{"orbit.greatest", 1 / 3.5}, {"orbit.least", 1 / 3.5}});
    expect_verified(document);
}

/// On the inner side of the bar points go against its turn. The curvature at both ends of the half axes, -(10 - pen) /
/// pen^2 and -pen / (10 - pen)^2, is greatest where it is least on the circle of the bar's middle.
TEST(LinkageCurvatures, AreSolvedFor) {
    const std::string text = "[solver]\nstarts = 4\n[units]\nlength = \"mm\"\n[drive]\nlink = \"bar\"\n" +
                             with_any_value({"bend.least"}) + "[objective]\nminimize = \"bend.greatest\"\n";
    const ReadProblem read = testing::read_without_fault(trammel("{ min = 1, max = 9 }", text));
    ASSERT_TRUE(read.ok());
    const Result result = solve(read.problem, {});
    const Json document = mechwright::document(read.problem, result);
    EXPECT_EQ(document["status"], "solved");
    EXPECT_NEAR(document["objective"]["value"].get<double>(), -0.2, 1e-9);
    EXPECT_NE(summary(read.problem, result, {}).find("1/mm"), std::string::npos);
    expect_verified(document);
}

TEST(LinkageCurvatures, SayWhatIsWrong) {
    const auto expect_error = [&](const std::string& part, const std::string& has) {
        const std::string error = testing::first_error(kinds_with_rooms[0].text() + part);
        EXPECT_NE(error.find(has), std::string::npos) << error;
    };
    expect_error("[signals]\nbend = { curvature-of = \"Q\" }\n",
                 "'curvature-of' in the signal 'bend': there is no point 'Q'");
    expect_error("[signals]\nbend = { curvature-of = \"P\", on = \"crank\" }\n", "'on'");
    expect_error(
        "[signals]\nbend = { curvature-of = \"P\" }\nhigh = { y = \"P\" }\nall = { sum = { bend = 1, high = 1 "
        "} }\n",
        "the signal 'all' adds what has different units");
    const std::string linkage = trammel("15",
                                        "[drive]\nlink = \"bar\"\n[function]\nsignal = \"bend\"\nexpression = "
                                        "\"x\"\nfrom = 0\nto = 1\n");
    EXPECT_NE(testing::first_error(linkage).find("is a curvature: the output of a function is an angle or a length"),
              std::string::npos)
        << testing::first_error(linkage);
}

}  // namespace

}  // namespace mechwright::linkage_scans
