// What closed forms prove of crank shapers, against every lever and ram line of a grid, by a formula that stands here.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "synthesis/exact/closed_form/closed_form.h"
#include "synthesis/problem/reader.h"
#include "tests/degree.h"

namespace mechwright {
namespace {

struct Shaper {
    double time_ratio, lever_min, lever_max, rod, line_min, line_max, asked;
};

/// The best transmission angle, degrees, of a grid of levers and ram lines.
double best_of_grid(const Shaper& s) {
    constexpr int steps = 400;
    const double ratio = std::cos(std::numbers::pi / (1 + s.time_ratio));
    double least = 1;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            const double lever = s.lever_min + (s.lever_max - s.lever_min) * i / steps;
            const double line = s.line_min + (s.line_max - s.line_min) * j / steps;
            const double lowest = lever * std::sqrt(1 - ratio * ratio);
            least = std::min(least, std::max(lever - line, line - lowest) / s.rod);
        }
    return std::acos(least) / degree;
}

TEST(CrankShapers, WhatIsProvenOfLeversAndRamLinesHoldsOnAGrid) {
    std::mt19937 random(static_cast<unsigned>(1 + ::testing::UnitTest::GetInstance()->random_seed()));
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    int solved = 0, infeasible = 0;
    for (int round = 0; round < 100; ++round) {
        Shaper s{};
        s.time_ratio = between(1.1, 2.5);
        s.lever_min = between(10, 150);
        s.lever_max = s.lever_min + between(1, 200);
        s.rod = between(100, 300);
        s.line_min = between(10, 200);
        s.line_max = s.line_min + between(1, 150);
        s.asked = between(60, 89);
        const std::string text = fmt::format(
            "schema = 1\nmechanism = \"crank-shaper\"\n[dimensions]\ncentre-distance = 100\n"
            "crank = {{ min = 1, max = 99.9 }}\nlever = {{ min = {}, max = {} }}\nrod = {{ min = 50, max = {} }}\n"
            "ram-distance = {{ min = {}, max = {} }}\n[[require]]\nquantity = \"time-ratio\"\nequal = {}\n"
            "[[require]]\nquantity = \"transmission-angle-worst\"\nmin = {}\n"
            "[objective]\nmaximize = \"transmission-angle-worst\"\n",
            s.lever_min, s.lever_max, s.rod, s.line_min, s.line_max, s.time_ratio, s.asked);
        const ReadProblem read = parse_problem(text, "shaper.toml");
        ASSERT_TRUE(read.messages.empty()) << to_string(read.messages.front());
        const auto outcome = solve_in_closed_form(read.problem);
        if (!outcome) continue;
        const double best = best_of_grid(s);
        if (outcome->infeasible) {
            ++infeasible;
            EXPECT_LT(best, s.asked) << text;
        } else {
            ++solved;
            EXPECT_GE(outcome->best->objective, best - 1e-9) << text;
        }
    }
    EXPECT_GT(solved, 5);
    EXPECT_GT(infeasible, 5);
}

}  // namespace
}  // namespace mechwright
