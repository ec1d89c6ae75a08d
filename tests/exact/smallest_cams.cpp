// The smallest cams by half-planes against a region cut out of a large square, half-plane by half-plane, by formulas
// that stand here.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "synthesis/document/document.h"
#include "synthesis/document/kinds_in_documents.h"
#include "synthesis/exact/closed_form/closed_form.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/proof.h"
#include "synthesis/solve/solve.h"
#include "synthesis/verify/verify.h"
#include "tests/degree.h"

namespace mechwright {
namespace {

using Point = Vector<double>;

/// What of a convex polygon has normal . x >= level.
std::vector<Point> cut(const std::vector<Point>& polygon, const Point& normal, double level) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double at_a = dot(normal, a) - level, at_b = dot(normal, b) - level;
        if (at_a >= 0) kept.push_back(a);
        if ((at_a < 0) != (at_b < 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    return kept;
}

double distance(const Point& target, const std::vector<Point>& polygon) {
    double least = std::numeric_limits<double>::infinity();
    bool inside = true;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &a = polygon[i], side = polygon[(i + 1) % polygon.size()] - a;
        const double square = dot(side, side);
        const double along = square > 0 ? std::clamp(dot(target - a, side) / square, 0.0, 1.0) : 0;
        const Point miss = target - (a + along * side);
        least = std::min(least, std::hypot(miss.x, miss.y));
        inside = inside && cross(side, target - a) >= 0;
    }
    return inside && !polygon.empty() ? 0 : least;
}

struct Cam {
    bool oscillating, harmonic, pivot_distance;
    int sense;
    double lift, rise, top, fall;  ///< degrees, of the lift too where the follower oscillates
    double limit, arm, least_offset, greatest_offset, greatest_size;
};

/// Lift and velocity of a rise or, seen backwards, of a return.
Point motion_at(const Cam& cam, double angle, double part) {
    constexpr double pi = std::numbers::pi;
    const double lift = cam.oscillating ? cam.lift * degree : cam.lift;
    return cam.harmonic ? Point{lift / 2 * (1 - std::cos(pi * part)), lift * pi / (2 * angle) * std::sin(pi * part)}
                        : Point{lift * (part - std::sin(2 * pi * part) / (2 * pi)),
                                lift / angle * (1 - std::cos(2 * pi * part))};
}

/// At least how far the cam centre is from the target, at so many places of each segment; infinite where it cannot be.
double least_size(const Cam& cam) {
    constexpr double far = 1e5;
    constexpr int places = 720;
    std::vector<Point> region{{-far, 0}, {far, 0}, {far, far}, {-far, far}};
    if (!cam.oscillating) {
        region = cut(region, {1, 0}, cam.least_offset);
        region = cut(region, {-1, 0}, -cam.greatest_offset);
    }
    const double tangent = std::tan(cam.limit * degree);
    for (const double direction : {1.0, -1.0})
        for (int i = 0; i <= places && !region.empty(); ++i) {
            const Point m = motion_at(cam, (direction > 0 ? cam.rise : cam.fall) * degree, double(i) / places);
            const double lift = m.x, velocity = direction * m.y;
            for (const double side : {1.0, -1.0}) {
                if (!cam.oscillating) {
                    // side (velocity - offset) <= tangent (height + lift)
                    region = cut(region, {side, tangent}, side * velocity - tangent * lift);
                    continue;
                }
                // side (arm velocity + sense arm - sense c cos psi) <= tangent c sin psi
                const Point along{std::cos(lift), -std::sin(lift)}, across{std::sin(lift), std::cos(lift)};
                region =
                    cut(region, side * cam.sense * along + tangent * across, side * cam.arm * (velocity + cam.sense));
            }
        }
    const bool from_arm = cam.oscillating && !cam.pivot_distance;
    return distance({from_arm ? cam.arm : 0, 0}, region);
}

std::string text_of(const Cam& cam) {
    const char* law = cam.harmonic ? "harmonic" : "cycloidal";
    const auto moving = [&](const char* kind, double angle) {
        return fmt::format("[[segment]]\nkind = \"{}\"\nangle = {}\nlift = {}\nlaw = \"{}\"\n", kind, angle, cam.lift,
                           law);
    };
    const auto dwell = [](double angle) { return fmt::format("[[segment]]\nkind = \"dwell\"\nangle = {}\n", angle); };
    const std::string dimensions =
        cam.oscillating
            ? fmt::format(
                  "prime-radius = {{ min = 0.001, max = {0} }}\npivot-distance = {{ min = 0.001, max = {0} }}\n"
                  "arm-length = {1}\n",
                  cam.greatest_size, cam.arm)
            : fmt::format("prime-radius = {{ min = 0.001, max = {} }}\noffset = {{ min = {}, max = {} }}\n",
                          cam.greatest_size, cam.least_offset, cam.greatest_offset);
    return fmt::format(
        "schema = 1\nmechanism = \"cam\"\n[cam]\nfollower = \"knife\"\nmotion = \"{}\"\nrotation = \"{}\"\n{}{}{}{}"
        "[dimensions]\n{}[[require]]\nquantity = \"pressure-angle-max\"\nmax = {}\n[objective]\nminimize = \"{}\"\n",
        cam.oscillating ? "oscillating" : "translating", cam.sense > 0 ? "ccw" : "cw", moving("rise", cam.rise),
        dwell(cam.top), moving("return", cam.fall), dwell(360 - cam.rise - cam.top - cam.fall), dimensions, cam.limit,
        cam.pivot_distance ? "pivot-distance" : "prime-radius");
}

Cam random_cam(std::mt19937& random, bool oscillating) {
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    Cam cam{};
    cam.oscillating = oscillating;
    cam.harmonic = between(0, 1) < 0.5;
    cam.pivot_distance = oscillating && between(0, 1) < 0.5;
    cam.sense = between(0, 1) < 0.5 ? 1 : -1;
    cam.lift = between(5, 35);
    cam.rise = between(40, 150);
    cam.top = between(1, 40);
    cam.fall = between(40, 150);
    cam.limit = between(12, 55);
    cam.arm = between(20, 100);
    cam.least_offset = -between(0, 30);
    cam.greatest_offset = between(0, 30);
    cam.greatest_size = std::exp(between(3, 7));
    return cam;
}

/// What the closed form says has to agree with the region; it may say nothing.
void expect_agreement(const Cam& cam, int& solved, int& infeasible) {
    const std::string text = text_of(cam);
    const ReadProblem read = parse_problem(text, "random.toml");
    ASSERT_TRUE(read.messages.empty()) << to_string(read.messages.front()) << text;
    ASSERT_EQ(why_no_closed_form(read.problem), "") << text;
    const auto outcome = solve_in_closed_form(read.problem);
    if (!outcome) return;
    // Fewer half-planes leave more room, and 720 places nearly none.
    const double least = least_size(cam);
    constexpr double missing = 1e-4;
    if (outcome->infeasible) {
        ++infeasible;
        EXPECT_GT(least, cam.greatest_size * (1 - missing)) << outcome->proof->argument << "\n" << text;
        return;
    }
    ++solved;
    const double size = outcome->best->objective;
    EXPECT_GE(size, least * (1 - 1e-9)) << text;
    EXPECT_LE(size, std::max(least, 0.001) * (1 + missing)) << text;
}

TEST(SmallestCams, ClosedFormsAgreeWithTheRegionCutOut) {
    // A shuffled run (--gtest_shuffle) draws others.
    std::mt19937 random(static_cast<unsigned>(1 + ::testing::UnitTest::GetInstance()->random_seed()));
    int solved = 0, infeasible = 0;
    constexpr int rounds = 150;
    for (int round = 0; round < rounds; ++round)
        expect_agreement(random_cam(random, round % 3 != 0), solved, infeasible);
    EXPECT_GT(solved, rounds / 4);
    EXPECT_GT(infeasible, rounds / 20);
    RecordProperty("solved", solved);
    RecordProperty("infeasible", infeasible);
}

std::string arm_of_80(double limit) {
    return fmt::format(R"(schema = 1
mechanism = "cam"
[cam]
follower = "roller"
motion = "oscillating"
rotation = "ccw"
[[segment]]
kind = "rise"
angle = 120
lift = 20
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 30
[[segment]]
kind = "return"
angle = 120
lift = 20
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 90
[dimensions]
prime-radius = {{ min = 5, max = 200 }}
pivot-distance = {{ min = 20, max = 300 }}
arm-length = 80
roller-radius = 5
[[require]]
quantity = "pressure-angle-max"
max = {}
[objective]
minimize = "pivot-distance"
)",
                       limit);
}

TEST(SmallestCams, NearlyParallelLimitsOfAnOscillatingFollowerLeaveRoom) {
    for (const auto& [limit, known] : {std::pair{28.0, 94.874343}, {40.0, 85.446057}}) {
        const ReadProblem read = parse_problem(arm_of_80(limit), "arm.toml");
        const Result result = solve(read.problem, {});
        ASSERT_EQ(result.status, Status::solved) << limit;
        EXPECT_LE(result.best->objective, known + 1e-6) << limit;
        EXPECT_TRUE(result.verified());
    }
}

struct SmallCircle {
    std::string head, rise_laws, return_laws, dimension, rest;
    double lift, greatest;
    std::string variant;  ///< that would do with least
    std::string named;    ///< the dimension in words

    std::string text(double most) const {
        const auto moving = [&](const char* kind, double angle, const std::string& laws) {
            return fmt::format("[[segment]]\nkind = \"{}\"\nangle = {}\nlift = {}\nlaw = {}\n", kind, angle, lift,
                               laws);
        };
        const auto dwell = [](double angle) {
            return fmt::format("[[segment]]\nkind = \"dwell\"\nangle = {}\n", angle);
        };
        return "schema = 1\nmechanism = \"cam\"\n[cam]\n" + head + moving("rise", 100, rise_laws) + dwell(40) +
               moving("return", 80, return_laws) + dwell(140) +
               fmt::format("[dimensions]\n{} = {{ min = 1, max = {} }}\n", dimension, most) + rest +
               fmt::format("[objective]\nminimize = \"{}\"\n", dimension);
    }
};

const std::string some_laws = R"(["cycloidal", "harmonic", "3-4-5"])";

const std::vector<SmallCircle>& too_small_circles() {
    static const std::vector<SmallCircle> all{
        {"follower = \"roller\"\nmotion = \"oscillating\"\nrotation = \"either\"\n", "\"cycloidal\"", "\"3-4-5\"",
         "prime-radius",
         "pivot-distance = { min = 20, max = 300 }\narm-length = 60\nroller-radius = 5\n"
         "[[require]]\nquantity = \"pressure-angle-rise\"\nmax = 30\n"
         "[[require]]\nquantity = \"pressure-angle-return\"\nmax = 42\n",
         22, 29.5, "turning clockwise", "prime-radius"},
        {"follower = \"roller\"\nrotation = \"ccw\"\n", some_laws, some_laws, "prime-radius",
         "roller-radius = 4\n[[require]]\nquantity = \"pressure-angle-max\"\nmax = 25\n", 15, 20, "harmonic return",
         "prime-radius"},
        {"follower = \"flat\"\nrotation = \"ccw\"\n", some_laws, some_laws, "base-radius",
         "[[require]]\nquantity = \"profile-radius-min\"\nmin = 4\n", 15, 20, "harmonic return", "base radius"}};
    return all;
}

// Of every rotation and choice of laws there is another least circle: the least of them is what a wider range gives.
TEST(SmallestCams, WhereNoneFitsTheLeastOfAllVariantsIsNamed) {
    for (const SmallCircle& circle : too_small_circles()) {
        const Problem narrow = parse_problem(circle.text(circle.greatest), "narrow.toml").problem;
        const Result none = solve(narrow, {});
        ASSERT_EQ(none.status, Status::infeasible) << circle.text(circle.greatest);
        EXPECT_TRUE(all_passed(verify(document(narrow, none))));
        const std::string& argument = none.search.proof->argument;
        const std::string before = "the least " + circle.named + " is ";
        ASSERT_NE(argument.find(before), std::string::npos) << argument;
        const double least = std::stod(argument.substr(argument.find(before) + before.size()));
        EXPECT_GT(least, circle.greatest);
        const std::string closest =
            kind_in_documents(*narrow.mechanism)->choices_text(narrow, none.best->design.assembly);
        EXPECT_NE(closest.find(circle.variant), std::string::npos) << closest;

        const Result wider = solve(parse_problem(circle.text(1.01 * least), "wider.toml").problem, {});
        ASSERT_EQ(wider.status, Status::solved) << least;
        EXPECT_TRUE(wider.search.complete());
        EXPECT_NEAR(wider.best->objective, least, 1e-8 * least);
        EXPECT_EQ(wider.best->design.assembly, none.best->design.assembly);
    }
}

// A proof that says nothing of one of the variants, or a cam that turns as none was to.
TEST(SmallestCams, ProofsThatLeaveAVariantOutDoNotVerify) {
    for (const SmallCircle& circle : too_small_circles()) {
        const Problem narrow = parse_problem(circle.text(circle.greatest), "narrow.toml").problem;
        const auto good = document(narrow, solve(narrow, {}));
        const std::size_t parts = good["search"]["certificate"]["parts"].size();
        EXPECT_EQ(parts, narrow.assemblies.size());
        for (std::size_t i = 0; i < parts; ++i) {
            auto bad = good;
            bad["search"]["certificate"]["parts"].erase(i);
            EXPECT_FALSE(all_passed(verify(bad))) << i;
        }
        auto bad = good;
        bad["design"]["rotation"] = good["design"]["rotation"] == "cw" ? "ccw" : "cw";
        EXPECT_FALSE(all_passed(verify(bad)));
    }
}

// The smallest cam under its limit would be undercut: the closed form has to leave it to the search.
TEST(SmallestCams, AnUndercutCamIsNoAnswer) {
    const ReadProblem read = parse_problem(R"(schema = 1
mechanism = "cam"
[cam]
follower = "roller"
motion = "translating"
rotation = "cw"
[[segment]]
kind = "rise"
angle = 124.2943155873794
lift = 8.405545727370443
law = "modified-constant-velocity"
[[segment]]
kind = "dwell"
angle = 79.61492894240776
[[segment]]
kind = "return"
angle = 62.955948123542136
lift = 8.405545727370443
law = "modified-constant-velocity"
[[segment]]
kind = "dwell"
angle = 93.1348073466707
[dimensions]
prime-radius = { min = 11.03462272461519, max = 400.0 }
offset = { min = -35.02484385597531, max = 35.02484385597531 }
roller-radius = 10.53462272461519
[[require]]
quantity = "pressure-angle-max"
max = 21.1419879895901
[objective]
minimize = "prime-radius"
)",
                                           "undercut.toml");
    const Result result = solve(read.problem, {});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.verified());
    EXPECT_LE(result.best->objective, 21.7285);  // of one that was found by another method
}

}  // namespace
}  // namespace mechwright
