// A mechanism that is none of the fixed kinds, made while the program runs: an elliptic trammel, whose model is the
// angle between its two slots. Everything that takes a problem file takes one of it.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "synthesis/document/document.h"
#include "synthesis/mechanism/drawing/moving_design.h"
#include "synthesis/mechanism/drawing/outlines.h"
#include "synthesis/mechanism/explanations/explanations.h"
#include "synthesis/mechanism/guided_point.h"
#include "synthesis/mechanism/measure_by.h"
#include "synthesis/mechanism/over_range.h"
#include "synthesis/problem/reader.h"
#include "synthesis/report/drawing/finished.h"
#include "synthesis/report/drawing/svg.h"
#include "synthesis/report/text/explained.h"
#include "synthesis/solve/solve.h"
#include "synthesis/verify/verify.h"
#include "tests/study/studies.h"

namespace mechwright {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The cotangent of the angle from the first slot, along which the first end of the rod slides, to the second.
struct Slots {
    double cotangent;
};

const Slots& slots_of(const void* model) { return *static_cast<const Slots*>(model); }

/// Dimensions: rod, point-along, point-across, origin-x, origin-y, tilt, crank-start. The rod's direction is the crank
/// angle; its second end stays on the second slot, so the first is where the height of the second says.
template <class T>
T slider(const T& rod, const T& direction, const T& cotangent) {
    using std::cos, std::sin;
    return rod * (sin(direction) * cotangent - cos(direction));
}

struct RodPoint {
    using Model = Slots;
    static constexpr std::size_t reads = 6;
    template <class T>
    static MissAndMargin<T> miss(Form form, const std::array<T, reads + 1>& x, const Vector<double>& target) {
        using std::cos, std::sin;
        const Vector<T> along{cos(x[6]), sin(x[6])}, tilt{cos(x[5]), sin(x[5])};
        const Vector<T> point = Vector<T>{slider(x[0], x[6], T(slots_of(form.model).cotangent)), T(0)} +
                                turned(Vector<T>{x[1], x[2]}, along);
        const Vector<T> at = Vector<T>{x[3], x[4]} + turned(point, tilt);
        return {{target.x - at.x, target.y - at.y}, 1.0};
    }
};

struct Stroke {
    static constexpr std::size_t reads = 1, most = 1;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        out[0] = T(2 * std::hypot(1.0, slots_of(motion.model).cotangent)) * x[0];
        return most;
    }
};

/// From one end of the way to the other, where the velocity of the slider is zero.
Digits50 stroke_again(const Motion& motion, std::span<const Digits50> d) {
    const Digits50 cotangent = slots_of(motion.model).cotangent, end = atan2(cotangent, Digits50(-1));
    return abs(slider(d[0], end, cotangent) - slider<Digits50>(d[0], end + Digits50(std::numbers::pi), cotangent));
}

Vector<Digits50> point_again(Form form, std::span<const Digits50> d, const Digits50& direction) {
    // The second end from the sine rule in the triangle of the slots' crossing and the two ends.
    const Digits50 cotangent = slots_of(form.model).cotangent, height = d[0] * sin(direction);
    const Vector<Digits50> second{height * cotangent, height}, along{cos(direction), sin(direction)};
    const Vector<Digits50> point = second + turned(Vector<Digits50>{d[1] - d[0], d[2]}, along);
    return Vector<Digits50>{d[3], d[4]} + turned(point, Vector<Digits50>{cos(d[5]), sin(d[5])});
}

Motion full_turn(Form form, std::span<const double>, const double* crank_range) {
    Motion motion;
    motion.assembly = form.assembly;
    motion.full_turn = crank_range == nullptr;
    motion.from = crank_range ? crank_range[0] : 0;
    motion.to = crank_range ? crank_range[1] : 2 * std::numbers::pi;
    return motion;
}

Motion full_turn_again(Form form, std::span<const Digits50>, const std::optional<Vector<Digits50>>& range) {
    Motion motion;
    motion.assembly = form.assembly;
    motion.to = 2 * std::numbers::pi;
    return range ? over_range(motion, *range) : motion;
}

std::string describe(Form form, std::span<const double>) {
    return slots_of(form.model).cotangent == 0 ? "trammel with square slots" : "trammel with skew slots";
}

std::vector<Check> check_motion(const Motion& motion, std::span<const Digits50> d) {
    Digits50 off = 0;
    for (int i = 0; i < 360; ++i) {
        const Digits50 direction = Digits50(i) / 57;
        const Digits50 cotangent = slots_of(motion.model).cotangent, first = slider(d[0], direction, cotangent);
        const Digits50 x = first + d[0] * cos(direction), y = d[0] * sin(direction);
        off = std::max<Digits50>(off, abs(x - cotangent * y) / d[0]);
    }
    return {{"both ends of the rod stay in their slots", off < Digits50("1e-45"), ""}};
}

bool row(const Motion& motion, std::span<const double> d, double direction, std::span<double> out) {
    const Slots& slots = slots_of(motion.model);
    const double first = slider(d[0], direction, slots.cotangent);
    const Vector<double> along{std::cos(direction), std::sin(direction)};
    const Vector<double> point =
        Vector<double>{d[3], d[4]} + turned(Vector<double>{first, 0} + turned(Vector<double>{d[1], d[2]}, along),
                                            Vector<double>{std::cos(d[5]), std::sin(d[5])});
    out[0] = direction;
    out[1] = first;
    out[2] = point.x;
    out[3] = point.y;
    return true;
}

std::vector<Body> bodies(const MovingDesign& design, double, double) {
    const double rod = design["rod"];
    const Vector<double> point{design["point-along"], design["point-across"]};
    return {{"rod", {outlines::polygon({{0, 0}, {rod, 0}, point})}, {{0, 0}, {rod, 0}}, {point}}};
}

bool place(const MovingDesign& design, double direction, std::size_t, std::span<BodyPlace> places) {
    const Vector<double> tilt{std::cos(design["tilt"]), std::sin(design["tilt"])};
    const double first = slider(design["rod"], direction, slots_of(design.motion.model).cotangent);
    const BodyPlace slots{{design["origin-x"], design["origin-y"]}, tilt};
    places[0] = {in_drawing(slots, {first, 0}), turned(Vector<double>{std::cos(direction), std::sin(direction)}, tilt)};
    return true;
}

Mechanism trammel(const std::string& name, double cotangent) {
    Mechanism m;
    m.name = name;
    m.meaning = "a rod whose ends slide in two crossing slots";
    m.dimensions = {{"rod", DimensionKind::length, true, "rod between its two sliding ends"},
                    {"point-along", DimensionKind::coordinate, false, "point along the rod, from its first end"},
                    {"point-across", DimensionKind::coordinate, false, "point to the left of the rod"},
                    {"origin-x", DimensionKind::coordinate, false, "where the slots cross"},
                    {"origin-y", DimensionKind::coordinate, false, "where the slots cross"},
                    {"tilt", DimensionKind::angle, false, "direction of the first slot"}};
    m.quantities = {{.name = "stroke",
                     .unit = Unit::length,
                     .meaning = "way of the rod's first end",
                     .reads = Stroke::reads,
                     .defined = [](const Motion&) { return true; },
                     .components = [](const Motion&) { return Stroke::most; },
                     .measure = measure_by<Stroke>,
                     .measure_again = stroke_again}};
    m.families = {{"the rod turns fully", true, {}, {}}};
    m.model = Model(Slots{cotangent});
    m.motion = full_turn;
    m.motion_again = full_turn_again;
    m.describe = describe;
    m.check_motion = check_motion;
    m.table = {{"crank-angle", "slider-position", "point-x", "point-y"},
               {Unit::angle, Unit::length, Unit::length, Unit::length},
               row};
    m.drawing = Drawing{bodies, place, [](const MovingDesign&) { return std::vector<Vector<double>>{}; },
                        [](const MovingDesign& design) { return ends_of(design.motion); }};
    m.point = PointGuidance{
        .reads = RodPoint::reads, .roles = {1, 2, 3, 4, 5}, .miss = path_miss_by<RodPoint>, .point = point_again};
    m.targets = {"path"};
    return m;
}

/// Registered once for the whole process; the second one differs in its model alone.
void make_trammels() {
    static const auto square = add_mechanism(trammel("trammel", 0));
    static const auto skew = add_mechanism(trammel("skew-trammel", 1 / std::tan(60 * degree)));
}

/// Points of an ellipse with semi-axes 100 and 50, its centre at (20, 10), turned by 30 deg.
std::string points_of_an_ellipse() {
    std::string text = "points = [";
    for (int i = 0; i < 9; ++i) {
        const Vector<double> p{100 * std::cos(0.7 * i), 50 * std::sin(0.7 * i)};
        const Vector<double> at = turned(p, Vector<double>{std::cos(30 * degree), std::sin(30 * degree)});
        text += (i ? ", [" : "[") + std::to_string(20 + at.x) + ", " + std::to_string(10 + at.y) + "]";
    }
    return text + "]\n";
}

std::string path_problem(const std::string& mechanism) {
    return "schema = 1\nmechanism = \"" + mechanism + R"("
[dimensions]
rod = { min = 20, max = 400 }
point-along = { min = -300, max = 300 }
point-across = { min = -100, max = 100 }
origin-x = { min = -50, max = 50 }
origin-y = { min = -50, max = 50 }
tilt = { min = -90, max = 90 }
[path]
timing = "free"
)" + points_of_an_ellipse() +
           "[[require]]\nquantity = \"stroke\"\nequal = 300\n[objective]\nminimize = \"path-rms\"\n";
}

ReadProblem read_without_error(const std::string& text) {
    ReadProblem read = parse_problem(text, "trammel.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return read;
}

TEST(MadeAtRunTime, DrawsTheEllipseThatItIsAskedFor) {
    make_trammels();
    const ReadProblem read = read_without_error(path_problem("trammel"));
    const Result result = solve(read.problem, {});
    ASSERT_EQ(result.status, Status::solved) << result.note;
    EXPECT_TRUE(result.verified());
    const std::vector<double>& d = result.best->design.dimensions;
    EXPECT_NEAR(d[0], 150, 1e-6);
    // The point is (along - rod, -across; across, along) times (cos, sin) of the rod's direction: the product and the
    // sum of squares of the ellipse's semi-axes are the determinant and the sum of squares of this matrix.
    EXPECT_NEAR(std::abs((d[1] - d[0]) * d[1] + d[2] * d[2]), 100.0 * 50, 1e-3);
    EXPECT_NEAR((d[1] - d[0]) * (d[1] - d[0]) + d[1] * d[1] + 2 * d[2] * d[2], 100.0 * 100 + 50 * 50, 1e-3);
    EXPECT_LT(result.best->objective, 1e-5);

    const nlohmann::ordered_json json = document(read.problem, result);
    EXPECT_EQ(json["design"]["kind"], "trammel with square slots");
    for (const Check& check : verify(json))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
    nlohmann::ordered_json changed = json;
    changed["design"]["rod"] = d[0] * (1 + 1e-7);
    const auto checks = verify(changed);
    EXPECT_TRUE(std::any_of(checks.begin(), checks.end(), [](const Check& check) { return !check.passed; }));
}

TEST(MadeAtRunTime, ItsFunctionsGetItsModel) {
    make_trammels();
    for (const auto& [name, stroke] : {std::pair("trammel", 240.0), {"skew-trammel", 240 / std::sin(60 * degree)}}) {
        const ReadProblem read = read_without_error(std::string("schema = 1\nmechanism = \"") + name +
                                                    "\"\n[dimensions]\nrod = 120.0\npoint-along = 40.0\n");
        const Solution given{{{120, 40, 0, 0, 0, 0}, 0, {}}};
        const nlohmann::ordered_json json = analysis_document(read.problem, given);
        EXPECT_NEAR(json["quantities"]["stroke"].get<double>(), stroke, 1e-12 * stroke) << name;
        for (const Check& check : verify(json))
            EXPECT_TRUE(check.passed) << name << ", " << check.name << ": " << check.detail;
    }
}

TEST(MadeAtRunTime, IsDrawnFromItsDocument) {
    make_trammels();
    const ReadProblem read = read_without_error(path_problem("skew-trammel"));
    const Result result = solve(read.problem, {});
    ASSERT_TRUE(result.best);
    const FinishedOrNot finished = finished_design(document(read.problem, result));
    ASSERT_EQ(finished.defect, "");
    const std::string picture = svg_picture(finished.design, {"A trammel", 640, "", 0});
    EXPECT_NE(picture.find("A trammel"), std::string::npos);
    EXPECT_NE(picture.find("rod"), std::string::npos);
    const Scene scene = scene_of(finished.design, 1e-4);
    const MotionRow there(finished.design, 1.2);
    const auto drawn = guided_point(finished.design, scene, 1.2);
    ASSERT_TRUE(drawn);
    EXPECT_NEAR(drawn->x, there["point-x"], 1e-9);
    EXPECT_NEAR(drawn->y, there["point-y"], 1e-9);
}

TEST(MadeAtRunTime, IsStudied) {
    make_trammels();
    const testing::TemporaryFolder folder;
    const std::string file = folder.write("study.toml", path_problem("trammel") + R"([study]
"require.stroke.equal" = { from = 280, to = 320, count = 3 }
)");
    const auto rows = testing::run_to_end(file, folder.path / "study.sqlite");
    ASSERT_EQ(rows.size(), 3u);
    for (const auto& row : rows)
        EXPECT_EQ(row["status"], "solved") << row.dump();
}

TEST(MadeAtRunTime, ExplainsQuantitiesThatNoOtherHas) {
    Mechanism m = trammel("explained-trammel", 0);
    m.quantities.front().name = "way-of-the-slide";
    m.explanations = [] {
        return std::vector<Explanation>{
            {.name = "way-of-the-slide",
             .what = "How far the rod's first end slides.",
             .over = "a full turn of the rod",
             .formulas = {{"two crossing slots", "2 rod where they are square", "geometry"}},
             .usual = "less than its slot",
             .undefined = "",
             .require = "max = 300",
             .objective = "minimize",
             .related = "stroke"}};
    };
    EXPECT_EQ(find_explanation("way-of-the-slide"), nullptr);
    add_mechanism(std::move(m));
    const Explained found = explained("way-of-the-slide", "explained-trammel", false);
    EXPECT_NE(found.text.find("How far the rod's first end slides."), std::string::npos) << found.text;
    EXPECT_NE(found.text.find("2 rod where they are square"), std::string::npos) << found.text;
    // What others say is still said.
    EXPECT_NE(find_explanation("pressure-angle-max"), nullptr);
}

TEST(MadeAtRunTime, MayHaveSettingsOfItsOwn) {
    make_trammels();
    Mechanism geared = trammel("geared-trammel", 0);
    geared.settings = {{"gearing", "ratio", 2, 0, 10, "turns of the rod for one of the crank"}};
    add_mechanism(geared);
    const std::string text =
        "schema = 1\nmechanism = \"geared-trammel\"\n[dimensions]\nrod = 120.0\n[gearing]\nratio = ";
    EXPECT_EQ(read_without_error(text + "3\n").problem.settings[0], 3);
    EXPECT_FALSE(parse_problem(text + "11\n", "trammel.toml").ok());
}

// The same trammel with its dimensions in another order: formulas name those that they read.
TEST(MadeAtRunTime, ReadsItsDimensionsInTheOrderThatItNames) {
    make_trammels();
    Mechanism m = trammel("reordered-trammel", 0);
    std::swap(m.dimensions[1], m.dimensions[2]);
    std::swap(m.dimensions[4], m.dimensions[5]);
    m.point->reads = std::vector<std::size_t>{0, 2, 1, 3, 5, 4};
    m.point->roles = {2, 1, 3, 5, 4};
    add_mechanism(m);
    const Result plain = solve(read_without_error(path_problem("trammel")).problem, {});
    const ReadProblem read = read_without_error(path_problem("reordered-trammel"));
    const Result result = solve(read.problem, {});
    ASSERT_TRUE(plain.best && result.best);
    EXPECT_TRUE(result.verified());
    EXPECT_LT(result.best->objective, 1e-5);
    const std::vector<double>&there = plain.best->design.dimensions, &here = result.best->design.dimensions;
    EXPECT_NEAR(here[0], there[0], 1e-6);
    EXPECT_NEAR(std::abs((here[2] - here[0]) * here[2] + here[1] * here[1]), 100.0 * 50, 1e-3);
    for (const Check& check : verify(document(read.problem, result)))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

TEST(Mechanisms, AreWhole) {
    for (const auto& mechanism : mechanisms())
        EXPECT_EQ(why_not_whole(*mechanism), "") << mechanism->meaning;
}

TEST(MadeAtRunTime, IsRefusedWhereItIsNotWhole) {
    make_trammels();
    EXPECT_THROW(add_mechanism(trammel("trammel", 0)), std::invalid_argument) << "the name is taken";
    Mechanism dumb = trammel("dumb-trammel", 0);
    dumb.quantities.back().measure_again = nullptr;
    EXPECT_THROW(add_mechanism(dumb), std::invalid_argument);
    Mechanism pointless = trammel("pointless-trammel", 0);
    pointless.point->point = nullptr;
    EXPECT_THROW(add_mechanism(pointless), std::invalid_argument);
    EXPECT_EQ(find_mechanism("pointless-trammel"), nullptr);
    Mechanism aimless = trammel("aimless-trammel", 0);
    aimless.targets = {"path", "poses"};
    EXPECT_THROW(add_mechanism(aimless), std::invalid_argument) << "it guides no body";
    aimless.targets = {};
    EXPECT_THROW(add_mechanism(aimless), std::invalid_argument) << "it guides a point, and no problem can say so";
}

}  // namespace

}  // namespace mechwright
