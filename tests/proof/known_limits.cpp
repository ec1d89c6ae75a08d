// What no linkage of a kind can measure, whatever its dimensions.

#include "synthesis/proof/known_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "synthesis/mechanism/possible_values.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"

namespace mechwright {
namespace {

constexpr const char* any_four_bar = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 1, max = 200 }
crank = { min = 1, max = 200 }
coupler = { min = 1, max = 200 }
rocker = { min = 1, max = 200 }
[objective]
minimize = "total-length"
)";

constexpr const char* any_slider_crank = R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank = { min = 1, max = 200 }
rod = { min = 1, max = 200 }
offset = { min = -100, max = 100 }
[objective]
minimize = "total-length"
)";

/// What a random linkage measures of a quantity, or nothing.
std::optional<double> measured(const Problem& problem, const Design& design, std::string_view quantity) {
    return quantity_value(problem, static_cast<std::size_t>(find_quantity(*problem.mechanism, quantity)), design);
}

/// No limit excludes a linkage that is there: its own values are asked for, and each limit has to hold them.
TEST(KnownLimits, HoldForRandomLinkages) {
    std::mt19937 random(static_cast<unsigned>(1 + ::testing::UnitTest::GetInstance()->random_seed()));
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    int checked = 0;
    for (const char* text : {any_four_bar, any_slider_crank}) {
        const ReadProblem read = parse_problem(text, "random.toml");
        for (int round = 0; round < 5000; ++round) {
            Problem problem = read.problem;
            Design design;
            for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
                const bool coordinate = problem.mechanism->dimensions[i].kind != DimensionKind::length;
                const bool shape = problem.mechanism->dimensions[i].required;
                const double value = !shape ? 0 : coordinate ? between(-60, 60) : std::exp(between(1, 5));
                design.dimensions.push_back(value);
                problem.dimensions[i].min = problem.dimensions[i].max = value;
            }
            for (const char* quantity :
                 {"swing", "time-ratio", "stroke", "transmission-angle-worst", "transmission-angle-min"}) {
                if (find_quantity(*problem.mechanism, quantity) < 0) continue;
                const auto value = measured(problem, design, quantity);
                if (!value) continue;
                const auto index = static_cast<std::size_t>(find_quantity(*problem.mechanism, quantity));
                problem.requirements.push_back({index, *value, {}, {}});
            }
            if (problem.requirements.size() < 3) continue;
            ++checked;
            for (const KnownLimit& limit : known_limits(problem)) {
                const Asked asked = asked_of(problem, problem.mechanism->quantities[limit.quantity].name);
                EXPECT_LE(asked.least, limit.greatest + 1e-7) << limit.name;
                EXPECT_GE(asked.greatest, limit.least - 1e-7) << limit.name;
            }
        }
    }
    EXPECT_GT(checked, 500);
    RecordProperty("checked", checked);
}

}  // namespace
}  // namespace mechwright
