// Slider-cranks that guide a body through poses.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/slider_crank.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"
#include "tests/degree.h"
#include "tests/long_form.h"

namespace mechwright {
namespace {

const SliderCrank<double> made{1, 3, 0.4};
const CouplerPoint<double> point{1.5, 1.2};

/// Poses of a slider-crank whose slide is tilted by 25 deg, from (2, 1), its body turned by 10 deg from the rod.
std::string poses_at(const std::vector<double>& crank_angles) {
    const Placement<double> placement{{2, 1}, 25 * degree};
    std::string text;
    for (const double angle : crank_angles) {
        const auto p = pose(made, angle * degree);
        const auto at = placed(position(made, point, p), placement);
        text += fmt::format("[{:.17g}, {:.17g}, {:.17g}],", at.x, at.y, std::atan2(p.rod.y, p.rod.x) / degree + 35);
    }
    return text;
}

Problem guiding_problem(const std::string& origin, const std::string& poses, const std::string& method = "exact") {
    const ReadProblem read = parse_problem(R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank        = { min = 0, max = 100 }
rod          = { min = 0, max = 100 }
offset       = { min = -100, max = 100 }
point-along  = { min = -100, max = 100 }
point-across = { min = -100, max = 100 }
)" + origin + R"(
tilt         = { min = -180, max = 180 }
body-angle   = { min = -180, max = 180 }
[poses]
poses = [)" + poses + R"(]
[objective]
maximize = "transmission-angle-worst"
[solver]
method = ")" + method + "\"\n",
                                           "p.toml");
    EXPECT_TRUE(read.ok()) << (read.messages.empty() ? "" : read.messages.front().text);
    return read.problem;
}

const std::string anywhere = "origin-x = { min = -100, max = 100 }\norigin-y = { min = -100, max = 100 }";

TEST(SliderCrankPoses, AreMetByMembersOfAFamily) {
    for (const std::vector<double>& angles :
         {std::vector<double>{20, 110, 200, 280}, std::vector<double>{20, 150, 280}, std::vector<double>{20, 200}}) {
        if (angles.size() == 3 && !in_long_form()) continue;
        const Problem problem = guiding_problem(anywhere, poses_at(angles));
        RunOptions options;
        options.jobs = 2;
        const Result result = solve(problem, options);
        ASSERT_EQ(result.status, Status::solved) << angles.size();
        EXPECT_LT(path_values(problem, result.best->design)->greatest, 1e-11);
        // No worse than the one that made the poses.
        EXPECT_GT(result.best->objective, 90 - std::asin(1.4 / 3) / degree - 1e-6);
    }
}

/// Four poses and the crank's pivot on its line leave few: one of them made the poses.
TEST(SliderCrankPoses, HaveTheSliderCrankThatMadeThem) {
    const Problem problem =
        guiding_problem("origin-x = 2\norigin-y = { min = -100, max = 100 }", poses_at({20, 110, 200, 280}));
    RunOptions options;
    options.all = true;
    const Result result = solve(problem, options);
    ASSERT_EQ(result.status, Status::solved);
    const auto is_it = [](const Solution& s) {
        const auto& d = s.design.dimensions;
        return std::abs(d[0] - 1) + std::abs(d[1] - 3) + std::abs(d[2] - 0.4) + std::abs(d[5] - 2) +
                   std::abs(d[6] - 1) <
               1e-7;
    };
    EXPECT_TRUE(is_it(*result.best) || std::ranges::any_of(result.alternatives, is_it, &VerifiedDesign::solution));
    EXPECT_NE(why_not_applicable("exact", guiding_problem(anywhere, poses_at({20, 80, 140, 200, 260})))
                  .find("up to four poses"),
              std::string::npos);
}

/// The derivatives of the pose, against differences: least squares rely on them.
TEST(SliderCrankPoses, HaveTheDerivativesOfTheirFormula) {
    const Mechanism& mechanism = *find_mechanism("slider-crank");
    const std::vector<double> at{1, 3, 0.4, 1.5, 1.2, 2, 1, 0.4, 0.2};  // the arguments of the pose
    const std::size_t n = mechanism.body->reads.size() + 1;
    ASSERT_EQ(n, 10u);
    std::array<std::array<double, 16>, 4> gradient{};
    PoseMiss miss{};
    miss.place.gradient_x = gradient[0];
    miss.place.gradient_y = gradient[1];
    miss.turn.gradient_x = gradient[2];
    miss.turn.gradient_y = gradient[3];
    mechanism.body->miss(mechanism.form(0), at, 0.8, {0, 0}, {1, 0}, miss);
    const double h = 1e-6;
    for (std::size_t i = 0; i < n; ++i) {
        PoseMiss up{}, down{};
        auto high = at, low = at;
        double angle_up = 0.8, angle_down = 0.8;
        if (i < at.size()) {
            high[i] += h;
            low[i] -= h;
        } else {
            angle_up += h;
            angle_down -= h;
        }
        mechanism.body->miss(mechanism.form(0), high, angle_up, {0, 0}, {1, 0}, up);
        mechanism.body->miss(mechanism.form(0), low, angle_down, {0, 0}, {1, 0}, down);
        const auto expect_slope = [&](std::size_t k, double above, double below) {
            EXPECT_NEAR(gradient[k][i], (above - below) / (2 * h), 1e-8) << k << ' ' << i;
        };
        expect_slope(0, up.place.miss.x, down.place.miss.x);
        expect_slope(1, up.place.miss.y, down.place.miss.y);
        expect_slope(2, up.turn.miss.x, down.turn.miss.x);
        expect_slope(3, up.turn.miss.y, down.turn.miss.y);
    }
}

TEST(SliderCrankPoses, AreMetByLeastSquaresToo) {
    Problem problem = guiding_problem(anywhere, poses_at({20, 80, 140, 200, 260, 320}), "auto");
    problem.objective->terms = {{static_cast<std::size_t>(find_quantity(*problem.mechanism, "pose-rms")), false, 1}};
    const Result result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_LT(result.best->objective, 1e-11);
    EXPECT_NEAR(result.best->design.dimensions[1], 3, 1e-8);
}

}  // namespace
}  // namespace mechwright
