// Linkages that a slide drives, and linkages between stops, against closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/report/csv/motion_table.h"
#include "synthesis/report/text/summary.h"
#include "synthesis/solve/solve.h"
#include "synthesis/verify/verify.h"
#include "tests/mechanism/linkage_texts.h"
#include "tests/replaced.h"

namespace mechwright {

namespace {

using testing::replaced;
constexpr double degree_of_drive = std::numbers::pi / 180;

std::string text_of_linkage(const std::string& name) {
    std::ifstream in(MECHWRIGHT_SOURCE_DIR "/problems/linkage/" + name + ".toml");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

Problem driven_problem(const std::string& text) {
    const ReadProblem read = parse_problem(text, "driven.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return read.problem;
}

void expect_driven(const std::string& text, const std::vector<testing::KnownQuantity>& known,
                   double tolerance = 1e-13) {
    testing::expect_quantities(text, known, tolerance);
}

/// The turn of the tipping body at a length of its cylinder, degrees.
double tip(double length, double reach) {
    return -std::acos((2000. * 2000 + reach * reach - length * length) / (2 * 2000 * reach)) / degree_of_drive;
}

TEST(DrivenSlides, ACylinderTipsABodyByTheLawOfCosines) {
    const double reach = 1500;
    const auto speed = [&](double x) { return -x / (2000 * reach * std::sin(-tip(x, reach) * degree_of_drive)); };
    const auto acceleration = [&](double x) {
        const double angle = -tip(x, reach) * degree_of_drive, by = -speed(x);
        return -(1 / (2000 * reach) - std::cos(angle) * by * by) / std::sin(angle);
    };
    const std::string text =
        replaced(text_of_linkage("tipping-cylinder"), "reach = { min = 1100, max = 1600 }", "reach = 1500");
    expect_driven(replaced(text, "equal    = 40", "min      = 0"),
                  {{"tip.at(1200)", tip(1200, reach), 100},
                   {"tip.at(1700)", tip(1700, reach), 100},
                   {"tip.range", tip(1200, reach) - tip(2000, reach), 100},
                   {"tip.range(1300, 1900)", tip(1300, reach) - tip(1900, reach), 100},
                   {"tip.speed.at(1700)", speed(1700), 1e-3},
                   {"tip.speed.mean", (tip(2000, reach) - tip(1200, reach)) * degree_of_drive / 800, 1e-3},
                   {"tip.acceleration.at(1700)", acceleration(1700), 1e-6},
                   {"load.greatest", -1800 * std::sin(tip(2000, reach) * degree_of_drive), 2000}});
}

/// Without stops the motion is where the triangle closes: between 2000 - 1500 and 2000 + 1500.
TEST(DrivenSlides, MoveWhereTheLinkageCloses) {
    std::string text =
        replaced(text_of_linkage("tipping-cylinder"), "reach = { min = 1100, max = 1600 }", "reach = 1500");
    text = replaced(text, "equal    = 40", "min      = 0");
    text = replaced(text, "min      = 20", "min      = 0");
    text = replaced(text, "[motion]\ncrank_range = [1200, 2000]", "[motion]\nat = 700");
    text = replaced(text, "min   = 1200\n", "");
    const Problem problem = driven_problem(replaced(text, "max   = 2000\n", ""));
    const Solution solution = evaluate_given(problem);
    const Motion motion = motion_of(problem, solution.design);
    EXPECT_NEAR(motion.from, 500, 1e-9);
    EXPECT_NEAR(motion.to, 3500, 1e-9);
    EXPECT_FALSE(motion.full_turn);
    for (const Check& check : verify(analysis_document(problem, solution)))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

TEST(DrivenSlides, OneReachTipsTheBodyAsFarAsAskedFor) {
    double less = 1100, more = 1600;  // the body tips by less for more
    for (int i = 0; i < 60; ++i) {
        const double middle = (less + more) / 2;
        (tip(1200, middle) - tip(2000, middle) > 40 ? less : more) = middle;
    }
    const Problem problem = driven_problem(text_of_linkage("tipping-cylinder"));
    const Result result = solve(problem, {});
    ASSERT_TRUE(result.best);
    EXPECT_EQ(result.status, Status::solved);
    EXPECT_NEAR(*value_named(problem, result.best->design, "reach"), less, 1e-6);
    for (const Check& check : verify(document(problem, result)))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

TEST(DrivenSlides, AScissorsLiftRisesByItsFoot) {
    const auto height = [](double x) { return std::sqrt(1e6 - x * x) + 50; };
    const auto steepness = [](double x) { return -x / std::sqrt(1e6 - x * x); };
    const auto curvature = [](double x) { return -1e6 / std::pow(1e6 - x * x, 1.5); };
    for (const double scale : {1., 0.001}) {
        std::string text = text_of_linkage("scissors-ram") + "\n[placement]\nscale = " + std::to_string(scale) + "\n";
        expect_driven(text, {{"height.at(600)", scale * height(600), scale * 1000},
                             {"height.greatest", scale * height(300), scale * 1000},
                             {"height.least", scale * height(950), scale * 1000},
                             {"height.speed.at(600)", scale * steepness(600), scale},
                             {"height.speed.least", scale * steepness(950), 5 * scale},
                             {"height.acceleration.at(600)", scale * curvature(600), scale * 1e-3},
                             {"level.range", 0, 100}});
    }
}

/// A lever on the end of the other one, in line with the frame where the motion begins at its limit: the table stands
/// at half a turn there, and doubles know it to half their digits.
TEST(DrivenSlides, ATableBeginsAtHalfATurn) {
    const std::string text =
        replaced(text_of_linkage("scissors-ram"), "M = [\"arm / 2\", 0], C", "M = [\"arm\", 0], C");
    const double x = (950. * 950 + 1e6 - 250000) / (2 * 950);
    expect_driven(text,
                  {{"level.least", 180, 1}, {"level.greatest", 360 - std::acos((950 - x) / 500) / degree_of_drive, 1}},
                  1e-11);
}

/// What is a length is none of the angles that the file has in radians; and one of millimetres is one of metres.
TEST(DrivenSlides, AreNoAngles) {
    const std::string text = text_of_linkage("scissors-ram") + "\n[units]\nangle = \"rad\"\n";
    expect_driven(text, {{"height.at(600)", 850, 1000}, {"height.speed.at(600)", -0.75}, {"level.greatest", 0}});
    std::string metres = replaced(text, "arm = 1000", "arm = 1");
    metres = replaced(metres, "[\"arm / 2\", 50]", "[\"arm / 2\", 0.05]");
    metres = replaced(metres, "min   = 300", "min   = 0.3");
    metres = replaced(metres, "\"arm - 50\"", "\"arm - 0.05\"");
    expect_driven(metres, {{"height.at(0.6)", 0.85},
                           {"height.speed.at(0.6)", -0.75},
                           {"height.least", 0.05 + std::sqrt(1 - 0.95 * 0.95)}});
}

TEST(DrivenSlides, AreShownByTheirDisplacements) {
    const Problem problem = driven_problem(text_of_linkage("scissors-ram"));
    const Solution solution = evaluate_given(problem);
    EXPECT_NE(analysis_summary(problem, solution, {}).find("Motion: displacements from 300 mm to 950 mm, on branch"),
              std::string::npos)
        << analysis_summary(problem, solution, {});
    const std::string table = motion_table(problem, solution.design, 2);
    EXPECT_EQ(table.substr(0, table.find(',')), "displacement [mm]");
    EXPECT_NE(table.find("\n300,"), std::string::npos) << table;
    EXPECT_NE(table.find("\n625,"), std::string::npos) << table;
    EXPECT_NE(table.find("\n950,"), std::string::npos) << table;
}

TEST(Stops, EndTheMotionOfASliderCrank) {
    const auto angle = [](double x) { return std::acos((x * x + 1600 - 14400) / (80 * x)) / degree_of_drive; };
    const auto block = [](double t) { return 40 * std::cos(t) + std::sqrt(14400 - 1600 * std::sin(t) * std::sin(t)); };
    const std::string text = text_of_linkage("stopped-slider");
    const Problem problem = driven_problem(text);
    const Motion motion = motion_of(problem, evaluate_given(problem).design);
    EXPECT_NEAR(motion.from / degree_of_drive, angle(150), 1e-12);
    EXPECT_NEAR(motion.to / degree_of_drive, angle(90), 1e-12);
    // The mean speed is the way over the time; at 60 turns per minute a turn takes a second.
    const double time = (angle(90) - angle(150)) / 360, t = angle(90) * degree_of_drive;
    const double end_speed =
        -2 * std::numbers::pi * (40 * std::sin(t) + 1600 * std::sin(t) * std::cos(t) / (block(t) - 40 * std::cos(t)));
    expect_driven(text, {{"block.greatest", 150, 150},
                         {"block.least", 90, 150},
                         {"block.at(90)", std::sqrt(14400 - 1600), 150},
                         {"block.speed.mean", -60 / time, 400},
                         {"block.speed.greatest", end_speed, 400}});
    const std::string other = replaced(text, "at = 90 ", "at = 270 ");
    const Problem mirrored = driven_problem(other);
    const Motion back = motion_of(mirrored, evaluate_given(mirrored).design);
    EXPECT_NEAR(back.from / degree_of_drive, 360 - angle(90), 1e-11);
    EXPECT_NEAR(back.to / degree_of_drive, 360 - angle(150), 1e-11);
}

/// The mean of the block's place over a motion that ends at stops, by the rod's length: both ends move.
TEST(Stops, MoveWithTheDimensions) {
    std::string text =
        replaced(text_of_linkage("stopped-slider"), "rod   = 120", "rod   = { min = 100, max = 140, start = 120 }");
    text +=
        "\n[[require]]\nquantity = \"block.mean\"\nmin = 0\n\n[[require]]\nquantity = \"block.greatest\"\nmin = 0\n";
    const Problem problem = driven_problem(text);
    ASSERT_TRUE(problem.mechanism);
    for (const char* name : {"block.mean", "block.greatest"}) {
        const Quantity& quantity =
            problem.mechanism->quantities[static_cast<std::size_t>(find_quantity(*problem.mechanism, name))];
        const auto at = [&](double rod, std::vector<double>* gradient) {
            std::vector<double> dimensions{40, rod, 0, 0, 0};
            const Motion motion = motion_for(quantity, motion_of(*problem.mechanism, dimensions, 0, nullptr));
            std::vector<double> value(count_components(quantity, motion)), all(value.size() * dimensions.size());
            measure(quantity, motion, dimensions, {value, gradient ? std::span<double>(all) : std::span<double>(), {}});
            if (gradient) *gradient = all;
            return value.front();
        };
        std::vector<double> gradient;
        at(120, &gradient);
        const double h = 1e-3;
        const double difference = (8 * (at(120 + h, nullptr) - at(120 - h, nullptr)) -
                                   (at(120 + 2 * h, nullptr) - at(120 - 2 * h, nullptr))) /
                                  (12 * h);
        EXPECT_NEAR(gradient[1], difference, 1e-9) << name;
    }
}

/// Stops of a drive that turns may lie beyond a turn apart.
TEST(Stops, OfATurningDriveAreItsMotion) {
    std::string text = replaced(text_of_linkage("stopped-slider"), "min       = 90\n", "");
    text = replaced(text, "max       = \"rod + 30\"\n", "");
    text = replaced(text, "speed = 60 ", "min = -90\nmax = 400\nspeed = 60 ");
    const Problem problem = driven_problem(text);
    const Motion motion = motion_of(problem, evaluate_given(problem).design);
    EXPECT_FALSE(motion.full_turn);
    EXPECT_NEAR(motion.from / degree_of_drive, -90, 1e-12);
    EXPECT_NEAR(motion.to / degree_of_drive, 400, 1e-12);
    expect_driven(text, {{"block.greatest", 160, 160}, {"block.least", 80, 160}});
}

TEST(Stops, OfASlotAreAlongItsLine) {
    // A pin of a crank of 40 in a slot of a lever about (0, -100): it is sqrt(100^2 + 40^2 + 2 100 40 sin t) away.
    const std::string text = R"(
schema    = 1
mechanism = "linkage"
[links]
frame = { A = [0, 0], D = [0, -100] }
crank = { A = [0, 0], B = [40, 0] }
lever = { D = [0, 0] }
[[slot]]
pin       = "B"
in        = "lever"
point     = "D"
direction = 0
max       = 120
[drive]
link = "crank"
[signals]
lever = { angle = "lever" }
)";
    const Problem problem = driven_problem(text);
    const Motion motion = motion_of(problem, evaluate_given(problem).design);
    const double end = std::asin((14400. - 11600) / 8000);
    EXPECT_NEAR(motion.to - motion.from, std::numbers::pi + 2 * end, 1e-12);
    EXPECT_NEAR(motion.from, std::numbers::pi - end, 1e-12);
    expect_driven(text, {{"lever.at(270)", 90, 100}});
}

void expect_message(const std::string& text, const std::string& part) {
    std::string all;
    for (const Message& message : parse_problem(text, "driven.toml").messages)
        all += to_string(message) + '\n';
    EXPECT_NE(all.find(part), std::string::npos) << all;
    EXPECT_NE(all.find("driven.toml:"), std::string::npos) << all;
}

TEST(DrivenSlides, AreToldWhatIsWrong) {
    const std::string text = text_of_linkage("scissors-ram");
    expect_message(replaced(text, "min   = 300 ", "speed = 10 "),
                   "[drive] drives a slide, and 'speed' is turns per minute: leave it out");
    expect_message(replaced(text, "min   = 300 ", "min   = 990\nmax   = 980 #"), "");
    expect_message(replaced(replaced(text, "min   = 300 ", "min   = 990 "), "\"arm - 50\"", "980"),
                   "'min' has to be less than 'max' in [drive]");
    expect_message(text + "\n[path]\npoint = \"T\"\ntiming = \"prescribed\"\npoints = [[0, 900], [10, 800]]\n" +
                       "crank_angles = [200, 400]\n",
                   "the displacement 200 is not on the stroke of the slide that drives, which goes from 300 to 950");
    expect_message(replaced(replaced(text, "min   = 300 ", "min   = 1300 "), "\"arm - 50\"", "1400"),
                   "with these dimensions");
    const std::string crank = text_of_linkage("stopped-slider");
    expect_message(replaced(crank, "speed = 60 ", "min = 0\nmax = 1e9\nspeed = 60 "),
                   "the stops of its drive are more than 64 turns apart");
    expect_message(replaced(crank, "speed = 60 ", "min = 10\nspeed = 60 "),
                   "one stop does not end the turning of [drive]: give both 'min' and 'max'");
    expect_message(replaced(crank, "min       = 90", "min       = 400\n#"), "");
}

/// A crank-rocker whose rocker is a circular slot in the frame, about D.
const std::string rocker_in_slot = R"(
schema = 1
mechanism = "linkage"
[dimensions]
radius = 50
begin = 110
[links]
frame = { A = [0, 0], D = [70, 0] }
crank = { A = [0, 0], B = [20, 0] }
coupler = { B = [0, 0], C = [60, 0] }
[[slot]]
pin = "C"
in = "frame"
centre = "D"
radius = "radius"
min = "begin"
max = "begin + 50"
[drive]
link = "crank"
[assembly]
C = "left"
[signals]
tilt = { angle = "coupler" }
)";

TEST(CircularSlots, EndTheMotionWhereTheirPinIsAtAnEnd) {
    // Without an end the rocker swings from 98 to 146 deg.
    const double end = 110 * degree_of_drive, x = 70 + 50 * std::cos(end), y = 50 * std::sin(end),
                 far = std::hypot(x, y);
    const double beside = std::acos((far * far + 20 * 20 - 60 * 60) / (2 * 20 * far)), to_pin = std::atan2(y, x);
    const Problem problem = parse_problem(rocker_in_slot, "slot.toml").problem;
    ASSERT_TRUE(problem.mechanism);
    const Solution solution = evaluate_given(problem);
    const Motion motion = motion_of(problem, solution.design);
    EXPECT_FALSE(motion.full_turn);
    EXPECT_NEAR(std::remainder(motion.from - to_pin - beside, 2 * std::numbers::pi), 0, 1e-12);
    EXPECT_NEAR(std::remainder(motion.to - to_pin + beside, 2 * std::numbers::pi), 0, 1e-12);
    EXPECT_NEAR(motion.to - motion.from, 2 * std::numbers::pi - 2 * beside, 1e-12);
    const std::string text = analysis_document(problem, solution).dump();
    for (const Check& check : verify(nlohmann::ordered_json::parse(text)))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
    // An end elsewhere, and the motion is another.
    const auto other = verify(nlohmann::ordered_json::parse(replaced(text, "begin + 50", "begin + 30")));
    EXPECT_TRUE(std::any_of(other.begin(), other.end(), [](const Check& check) { return !check.passed; }));
    // Both ends: at 140 deg, too, at two crank angles between the others.
    const Problem both = parse_problem(replaced(rocker_in_slot, "begin + 50", "begin + 30"), "slot.toml").problem;
    const Motion part = motion_of(both, evaluate_given(both).design);
    const double last = 140 * degree_of_drive, across = 70 + 50 * std::cos(last), up = 50 * std::sin(last),
                 away = std::hypot(across, up);
    const double turned = std::atan2(up, across), besides = std::acos((away * away + 400 - 3600) / (40 * away));
    EXPECT_NEAR(part.to - part.from,
                std::max(std::remainder(turned + besides - to_pin - beside, 2 * std::numbers::pi),
                         std::remainder(to_pin - beside - turned + besides, 2 * std::numbers::pi)),
                1e-12);
}

TEST(CircularSlots, AreToldWhatTheirEndsHaveToBe) {
    expect_message(
        replaced(rocker_in_slot, "min = \"begin\"\n", "").replace(0, 1, "\n"),
        "[[slot]] number 1 is circular and needs both ends, or none: give 'min' and 'max', directions from its centre");
    expect_message(
        replaced(rocker_in_slot, "\"begin + 50\"", "\"2 begin\""),
        "[[slot]] number 1 is circular, and its arc has to be a number: write 'max' as 'min' and so much, like min = "
        "\"start\" and max = \"start + 40\"");
    expect_message(
        replaced(rocker_in_slot, "begin + 50", "begin + 360"),
        "[[slot]] number 1 is circular: its arc from 'min' to 'max' is more than 0 and less than a full turn");
}

}  // namespace

}  // namespace mechwright
