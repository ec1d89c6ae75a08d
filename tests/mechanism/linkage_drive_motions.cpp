// Drives that move as segments of a turn of the first one say, against closed forms of the laws of motion (Norton, Cam
// Design and Manufacturing Handbook; VDI 2143) and positions by intersected circles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "synthesis/document/document.h"
#include "synthesis/mechanism/linkage/mechanism.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"
#include "synthesis/verify/motion_again.h"
#include "synthesis/verify/verify.h"
#include "tests/long_form.h"
#include "tests/mechanism/linkage_known.h"
#include "tests/mechanism/linkage_texts.h"
#include "tests/replaced.h"

namespace mechwright {

namespace {

using testing::replaced;
constexpr double motion_pi = std::numbers::pi, motion_degree = std::numbers::pi / 180;

void expect_motion(const std::string& text, const std::vector<testing::KnownQuantity>& known,
                   double tolerance = 1e-12) {
    testing::expect_quantities(text, known, tolerance);
}

/// The rise of a modified sine up to an eighth of it.
double start_of_modified_sine(double u) { return (motion_pi * u - std::sin(4 * motion_pi * u) / 4) / (4 + motion_pi); }

/// The speed of the shipped unit's quill at a crank angle, by size.
double speed_of_quill(double crank) {
    const double in_half = std::fmod(crank, 180);
    const auto part = [&](double from) { return std::clamp((in_half - from) / 60, 0.0, 1.0); };
    const double u = part(15), v = part(105), w = 30 * 6.0;
    if (v > 0) return w * 30 * v * v * (1 - v) * (1 - v);
    const double c = motion_pi / (4 + motion_pi);
    if (u < 0.125 || u > 0.875) return w * c * (1 - std::cos(4 * motion_pi * u));
    return w * c * (1 - 3 * std::cos(4 * motion_pi * u / 3 + motion_pi / 3));
}

std::string given_pick_and_place() {
    std::string text = known_linkages::shipped_text("pick-and-place");
    text.resize(text.find("[[require]]"));
    text = replaced(text, "crank = { min = 30, max = 90 }", "crank = 60");
    return replaced(text, "rod   = { min = 150, max = 400 }", "rod = 275");
}

TEST(DriveMotions, APickAndPlaceUnitMovesByTheLawsOfItsCam) {
    const double lift = 30, time = 1.0 / 6, omega = 2 * motion_pi;
    const double sine_speed = 4 * motion_pi / (4 + motion_pi) * lift / time,
                 sine_acceleration = 4 * motion_pi * motion_pi / (4 + motion_pi) * lift / (time * time),
                 sine_jerk = 4 * motion_pi * sine_acceleration / time,
                 polynomial_acceleration = 10 / std::sqrt(3.0) * lift / (time * time);
    const auto across = [](double crank) {
        return 60 * std::cos(crank) + std::sqrt(275. * 275 - std::pow(60 * std::sin(crank), 2));
    };
    const double along =
        -omega * 60 * std::sin(motion_pi / 4) *
        (1 + 60 * std::cos(motion_pi / 4) / std::sqrt(275. * 275 - std::pow(60 * std::sin(motion_pi / 4), 2)));
    expect_motion(
        given_pick_and_place(),
        {{"height.least", -60, 100},
         {"height.greatest", -30, 100},
         {"height.range", 30, 100},
         {"across.range", 120, 100},
         {"across.at(70)", across(70 * motion_degree), 300},
         {"height.at(45)", -45, 100},
         {"height.at(10)", -60, 100},
         {"height.at(20)", -60 + lift * start_of_modified_sine(5. / 60), 100},
         {"height.speed.greatest", sine_speed, 1e3},
         {"height.speed.least", -15. / 8 * lift / time, 1e3},
         {"height.acceleration.greatest", polynomial_acceleration, 1e4},
         {"height.acceleration.least", -polynomial_acceleration, 1e4},
         {"height.acceleration.greatest(0, 90)", sine_acceleration, 1e4},
         {"height.acceleration.least(0, 90)", -sine_acceleration, 1e4},
         {"height.jerk.greatest", sine_jerk, 1e6},
         {"height.jerk.least", -60 * lift / std::pow(time, 3), 1e6},
         {"height.jerk.at(105)", -60 * lift / std::pow(time, 3), 1e6},
         {"height.mean(0, 75)", -48, 100},
         {"height.mean", -45, 100},
         {"height.rms(105, 165)", lift * std::sqrt(2 + 100. / 7 + 25 + 36. / 11 - 300. / 8 + 120. / 9 - 18), 100},
         {"height.speed.rms(105, 165)", std::sqrt(10. / 7) * lift / time, 1e3},
         {"height.acceleration.mean(105, 135)", -15. / 8 * lift / time / (time / 2), 1e4},
         {"height.speed.mean(0, 90)", lift / 0.25, 1e3},
         {"speed.at(45)", std::hypot(along, sine_speed), 1e3}});
}

/// A five-bar whose second crank swings on by 40 degrees and back.
std::string five_bar(const std::string& rise, const std::string& fall, double ground = 3) {
    return replaced(R"(
schema = 1
mechanism = "linkage"
[dimensions]
ground = GROUND
first = 1
second = 1.2
left = 2.5
right = 2.8
[links]
frame = { A = [0, 0], E = ["ground", 0] }
first = { A = [0, 0], B = ["first", 0] }
second = { E = [0, 0], D = ["second", 0] }
left = { B = [0, 0], P = ["left", 0] }
right = { D = [0, 0], P = ["right", 0] }
[[drive]]
link = "first"
[[drive]]
link = "second"
phase = 100
[[drive.segment]]
kind = "dwell"
angle = 50
[[drive.segment]]
kind = "rise"
angle = 120
lift = 40
)" + rise + R"(
[[drive.segment]]
kind = "dwell"
angle = 70
[[drive.segment]]
kind = "return"
angle = 120
lift = 40
)" + fall + R"(
[assembly]
P = { side = "left", from = "B", to = "D" }
[signals]
across = { x = "P" }
height = { y = "P" }
second = { angle = "second" }
)",
                    "GROUND", std::to_string(ground));
}

/// Where P is at a crank angle, by intersected circles.
Vector<double> point_of_five_bar(double crank, double ground = 3) {
    const double in_turn = crank - 2 * motion_pi * std::floor(crank / (2 * motion_pi));
    const auto cycloid = [](double u) { return u - std::sin(2 * motion_pi * u) / (2 * motion_pi); };
    const auto part = [&](double from) { return std::clamp((in_turn / motion_degree - from) / 120, 0.0, 1.0); };
    const double second = (100 + 40 * (cycloid(part(50)) - cycloid(part(240)))) * motion_degree;
    const Vector<double> b{std::cos(crank), std::sin(crank)},
        d{ground + 1.2 * std::cos(second), 1.2 * std::sin(second)}, base = d - b;
    const double apart = std::hypot(base.x, base.y), foot = (apart * apart + 2.5 * 2.5 - 2.8 * 2.8) / (2 * apart),
                 up = std::sqrt(2.5 * 2.5 - foot * foot);
    return b + foot / apart * base + up / apart * Vector<double>{-base.y, base.x};
}

TEST(DriveMotions, ACamAndACrankCloseAFiveBar) {
    const auto height = [](double crank) { return point_of_five_bar(crank).y; };
    const auto speed = [&](double crank) {  // by differences of the fourth order
        constexpr double h = 1e-3;
        return (8 * (height(crank + h) - height(crank - h)) - (height(crank + 2 * h) - height(crank - 2 * h))) /
               (12 * h);
    };
    double greatest = -10, least = 10, fastest = -10, mean = 0;
    constexpr int samples = 40000;
    for (int i = 0; i < samples; ++i) {
        const double crank = 2 * motion_pi * i / samples;
        greatest = std::max(greatest, height(crank));
        least = std::min(least, height(crank));
        fastest = std::max(fastest, speed(crank));
        mean += height(crank) / samples;
    }
    const std::string text = five_bar("law = \"cycloidal\"", "law = \"cycloidal\"");
    expect_motion(text, {{"across.at(20)", point_of_five_bar(20 * motion_degree).x},
                         {"height.at(100)", height(100 * motion_degree)},
                         {"height.at(300)", height(300 * motion_degree)},
                         {"second.at(110)", 120, 100},
                         {"second.range", 40, 100}});
    // As exact as the samples and differences are.
    expect_motion(text,
                  {{"height.speed.at(100)", speed(100 * motion_degree)},
                   {"height.greatest", greatest},
                   {"height.least", least},
                   {"height.speed.greatest", fastest},
                   {"height.mean", mean}},
                  1e-7);
}

/// Where acceleration or velocity jump, the extremes are those on either side.
TEST(DriveMotions, ExtremesLieWhereDerivativesJump) {
    const double lift = 40 * motion_degree, angle = 120 * motion_degree;
    expect_motion(five_bar("law = \"parabolic\"", "law = \"constant-velocity\""),
                  {{"second.acceleration.greatest", 4 * lift / (angle * angle)},
                   {"second.acceleration.least", -4 * lift / (angle * angle)},
                   {"second.acceleration.rms(0, 180)", 4 * lift / (angle * angle) * std::sqrt(120. / 180)},
                   {"second.speed.greatest", 2 * lift / angle},
                   {"second.speed.least", -lift / angle},
                   {"second.speed.at(240)", -lift / angle},
                   {"second.speed.mean(230, 300)", -lift / 2 / (70 * motion_degree)},
                   {"second.acceleration.mean(180, 350)", 0}});
}

TEST(DriveMotions, PolynomialsAndTablesAreMotions) {
    const auto rise = [](double u) { return u * u * u * (10 - 15 * u + 6 * u * u); };
    const auto steeper = [](double u) { return std::pow(u, 4) * (35 - 84 * u + 70 * u * u - 20 * u * u * u); };
    expect_motion(five_bar("law = \"polynomial\"", "law = \"polynomial\"\nstart = [0, 0, 0]\nend = [0, 0, 0]"),
                  {{"second.at(80)", 100 + 40 * rise(0.25), 100},
                   {"second.speed.greatest", 15. / 8 * 40 / 120},
                   {"second.at(300)", 100 + 40 * (1 - steeper(0.5)), 100},
                   {"second.at(270)", 100 + 40 * (1 - steeper(0.25)), 100}});
    std::string text = five_bar("", "");
    text.replace(text.find("[[drive.segment]]"), text.find("[assembly]") - text.find("[[drive.segment]]"),
                 R"([[drive.segment]]
kind = "cycle"
points = [[10, 0], [80, 12], [150, 25], [220, 31], [290, 14]]
)");
    expect_motion(text, {{"second.at(10)", 100, 100}, {"second.at(150)", 125, 100}, {"second.at(290)", 114, 100}});
}

/// A drive whose segments only rise indexes: four quarters of a turn.
TEST(DriveMotions, AnIndexingDriveComesRound) {
    std::string text = five_bar("law = \"cycloidal\"", "law = \"cycloidal\"");
    text = replaced(replaced(text, "kind = \"return\"", "kind = \"rise\""), "ground = 3.000000", "ground = 3.5");
    text = replaced(replaced(text, "lift = 40", "lift = 30"), "lift = 40", "lift = 60");
    text = replaced(replaced(text, "left = 2.5", "left = 4.5"), "right = 2.8", "right = 4.2");
    expect_motion(text, {{"second.at(0)", 100, 1000},
                         {"second.at(200)", 130, 1000},
                         {"second.at(240)", 130, 1000},
                         {"second.at(410)", 190, 1000},
                         {"second.at(1130)", 370, 1000},
                         {"second.range", 360, 1000},
                         {"second.acceleration.greatest",
                          2 * motion_pi * 60 * motion_degree / std::pow(120 * motion_degree, 2)}});
    EXPECT_EQ(linkage_of(testing::read_without_fault(text).problem.mechanism->model.data()).turns, 4);
}

TEST(DriveMotions, HaveExactDerivativesByTheDimensions) {
    std::string text = five_bar("law = \"modified-sine\"", "law = \"parabolic\"");
    for (const auto& [name, value] : {std::pair("first = 1\n", "first = { min = 0.5, max = 1.2, start = 1 }\n"),
                                      {"left = 2.5\n", "left = { min = 2, max = 3, start = 2.5 }\n"}})
        text = replaced(text, name, value);
    for (const char* name : {"height.speed.greatest", "height.acceleration.range", "across.rms", "height.speed.rms",
                             "height.acceleration.mean(20, 100)", "across.greatest", "height.jerk.least(60, 100)"})
        text += std::string("\n[[require]]\nquantity = \"") + name + "\"\nmin = -1e9\n";
    const ReadProblem read = testing::read_without_fault(text + "\n[objective]\nminimize = \"total-length\"\n");
    ASSERT_TRUE(read.ok());
    const Mechanism& m = *read.problem.mechanism;
    const std::vector<double> dimensions{3, 1, 1.2, 2.5, 2.8, 0, 0, 0};
    ASSERT_EQ(m.dimensions.size(), dimensions.size());
    Motion motion = m.motion(m.form(0), dimensions, nullptr);
    ASSERT_TRUE(motion.full_turn);
    for (const Quantity& quantity : m.quantities)
        if (quantity.name.find('.') != std::string::npos && quantity.name.find("second") == std::string::npos)
            testing::expect_slopes(m, quantity, motion, dimensions);
}

/// The rod that makes the gripper's greatest speed least, by golden section on the closed form of that.
TEST(DriveMotions, TheShippedUnitIsDesigned) {
    const auto greatest = [](double rod) {
        double most = 0;
        const int steps = cases_to_try(3600, 36000);  // a scan of 3600 misses less than the 1e-5th of the greatest
        for (int i = 0; i < steps; ++i) {
            const double t = i * 2 * motion_pi / steps, s = std::sin(t), c = std::cos(t);
            const double along = 2 * motion_pi * 60 * s * (1 + 60 * c / std::sqrt(rod * rod - 3600 * s * s));
            most = std::max(most, std::hypot(along, speed_of_quill(t / motion_degree)));
        }
        return most;
    };
    double best = 1e9;
    for (double rod = 150; rod <= 400; rod += 0.5)
        best = std::min(best, greatest(rod));
    const Problem problem =
        testing::read_without_fault(known_linkages::shipped_text("pick-and-place") +
                                    (in_long_form() ? "\n[solver]\nstarts = 4\n" : "\n[solver]\nstarts = 2\n"))
            .problem;
    const Result result = solve(problem, {});
    ASSERT_TRUE(result.best);
    EXPECT_NEAR(*value_named(problem, result.best->design, "crank"), 60, 1e-6);
    EXPECT_NEAR(result.best->objective, best, 1e-4 * best);
    for (const Check& check : verify(document(problem, result)))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

/// What verification measures of a linkage of given dimensions over its own motion, radians and lengths.
Digits50 again(const std::string& text, const std::string& name) {
    std::string asked = text;
    asked += "[[require]]\nquantity = \"" + name + "\"\nmax = 1e9\n";
    const Problem problem = testing::read_without_fault(asked).problem;
    std::vector<Digits50> dimensions;
    for (const DimensionRange& range : problem.dimensions)
        dimensions.emplace_back(range.min);
    const Mechanism& mechanism = *problem.mechanism;
    for (const Quantity& quantity : mechanism.quantities)
        if (quantity.name == name)
            return measure_again(quantity, motion_again(mechanism, problem.assemblies[0], dimensions, std::nullopt),
                                 dimensions);
    ADD_FAILURE() << name;
    return 0;
}

/// One whose cranks are so far apart that its motion has limits.
std::string far_five_bar() {
    return replaced(five_bar("law = \"cycloidal\"", "law = \"cycloidal\"", 5.05), "phase = 100", "phase = 20");
}

// The second crank rests while the first comes to the limit, where the two other links are in line: by the law of
// cosines.
TEST(DriveMotions, AnAngleAtTheLimitOfTwoDrivesIsMeasuredAgain) {
    const std::string text = replaced(far_five_bar(), "second = { angle = \"second\" }", "left = { angle = \"left\" }");
    const Vector<double> D{5.05 + 1.2 * std::cos(20 * motion_degree), 1.2 * std::sin(20 * motion_degree)};
    const double far = std::hypot(D.x, D.y), from_line = std::acos((1 + far * far - 5.3 * 5.3) / (2 * far));
    const double crank = std::atan2(D.y, D.x) + from_line;  // in the first dwell
    ASSERT_GT(crank, 0);
    ASSERT_LT(crank, 50 * motion_degree);
    const double left = std::atan2(D.y - std::sin(crank), D.x - std::cos(crank));
    const Digits50 found = again(text, "left.least");
    EXPECT_NEAR(found.convert_to<double>(), left, 1e-14);
}

// The pin of a rocker rests where crank and coupler are in line, and its speed has a corner there: its slopes on either
// side are the accelerations r1 (1 +- r1 / r2) / sin(mu) of the dead centres.
TEST(DriveMotions, SpeedsArePassedWhereAPointRests) {
    const std::string four_bar = R"(
schema = 1
mechanism = "linkage"
[dimensions]
ground = 4
crank = 1
coupler = 3.5
rocker = 2.5
[links]
frame = { A = [0, 0], D = ["ground", 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0] }
rocker = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
[assembly]
C = "left"
[signals]
v = { speed-of = "C" }
)";
    const auto slope = [](double sense) {
        const double reach = 3.5 + sense, cosine = (reach * reach + 2.5 * 2.5 - 16) / (2 * reach * 2.5);
        return (1 + sense / 3.5) / std::sqrt(1 - cosine * cosine);
    };
    EXPECT_NEAR(again(four_bar, "v.speed.greatest").convert_to<double>(), slope(1), 1e-13);
    EXPECT_NEAR(again(four_bar, "v.speed.greatest(100, 250)").convert_to<double>(), slope(-1), 1e-13);
    const Problem problem =
        testing::read_without_fault(four_bar + "[[require]]\nquantity = \"v.speed.greatest\"\nmax = 2\n").problem;
    for (const Check& check : verify(analysis_document(problem, evaluate_given(problem))))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

// Where a motion ends at a limit its speed is infinite: no value, none that is stated, and nothing wrong with that.
TEST(DriveMotions, WhatHasNoValueIsNotStated) {
    const std::string text = in_long_form() ? far_five_bar()
                                            : replaced(replaced(far_five_bar(), "across = { x = \"P\" }\n", ""),
                                                       "second = { angle = \"second\" }\n", "");
    const Problem problem =
        testing::read_without_fault(text + "[[require]]\nquantity = \"height.speed.range\"\nmax = 1e9\n").problem;
    auto document = analysis_document(problem, evaluate_given(problem));
    const auto as_stated = [&] {
        bool all = true;
        for (const Check& check : verify(document))
            if (check.name.ends_with("as stated")) all = all && check.passed;
        return all;
    };
    EXPECT_FALSE(document["requirements"][0].contains("value"));
    EXPECT_TRUE(as_stated());
    document["requirements"][0]["value"] = 7.0;
    EXPECT_FALSE(as_stated());
}

TEST(DriveMotions, WrongOnesAreToldWhereAndWhy) {
    const std::string right = five_bar("law = \"cycloidal\"", "law = \"cycloidal\"");
    const auto expect_fault = [](const std::string& text, const std::string& fault) {
        EXPECT_NE(testing::first_error(text).find(fault), std::string::npos) << testing::first_error(text);
    };
    expect_fault(replaced(right, "angle = 50", "angle = 40"), "add up to 350 deg, 10 deg short of a full turn");
    expect_fault(replaced(right, "angle = 50", "angle = { min = 40, max = 60 }"), "must be a number");
    expect_fault(replaced(right, "angle = 50", "angle = -50"), "must be greater than 0");
    expect_fault(replaced(right, "lift = 40", "lift = 30"), "do not add up to zero: it ends a turn -10 deg from");
    expect_fault(replaced(right, "law = \"cycloidal\"", "law = \"cycloid\""), "law");
    expect_fault(replaced(right, "law = \"cycloidal\"", "law = [\"cycloidal\", \"3-4-5\"]"), "must be one law");
    expect_fault(replaced(right, "phase = 100", "ratio = 2"), "stands in place of 'ratio'");
    expect_fault(replaced(right, "law = \"cycloidal\"", "law = \"cycloidal\"\npoints_file = \"a.csv\""), "points_file");
    expect_fault(replaced(right, "kind = \"rise\"", "kind = \"climb\""), "kind");
    expect_fault(replaced(right, "kind = \"rise\"", "kind = \"cycle\"\npoints = [[0, 0], [90, 1], [180, 2], [270, 1]]"),
                 "must be the only one");
    std::string first = right;
    first.erase(first.find("[[drive]]"),
                first.find("[[drive]]", first.find("[[drive]]") + 1) - first.find("[[drive]]"));
    expect_fault(first, "is of further drives");
    std::string empty = right;
    empty.replace(empty.find("[[drive.segment]]"), empty.find("[assembly]") - empty.find("[[drive.segment]]"),
                  "segment = []\n");
    expect_fault(empty, "[[drive.segment]]");
}

}  // namespace

}  // namespace mechwright
