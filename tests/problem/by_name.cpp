#include "synthesis/problem/by_name.h"

#include <gtest/gtest.h>

#include <numbers>

#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"

namespace {

using namespace mechwright;

constexpr double degree = std::numbers::pi / 180;

Problem crank_rocker() {
    Problem problem = problem_of("four-bar");
    fix(problem, "ground", 100);
    design_within(problem, "crank", 5, 60);
    design_within(problem, "coupler", 20, 300);
    design_within(problem, "rocker", 20, 300, 90);
    require_equal(problem, "time-ratio", 1.2);
    require_equal(problem, "swing", 60 * degree);
    maximize(problem, "transmission-angle-worst");
    return problem;
}

TEST(ByName, AProblemIsThatOfItsFile) {
    const Problem problem = crank_rocker();
    EXPECT_EQ(why_not_whole(problem), "");
    const ReadProblem read = parse_problem(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = { min = 5, max = 60 }
coupler = { min = 20, max = 300 }
rocker = { min = 20, max = 300, start = 90 }
[[require]]
quantity = "time-ratio"
equal = 1.2
[[require]]
quantity = "swing"
equal = 60
[objective]
maximize = "transmission-angle-worst"
)",
                                           "crank-rocker.toml");
    ASSERT_TRUE(read.ok());
    const Result mine = solve(problem, {}), of_file = solve(read.problem, {});
    ASSERT_EQ(mine.status, Status::solved);
    EXPECT_TRUE(mine.verified());
    for (const Dimension& dimension : read.problem.mechanism->dimensions)
        EXPECT_EQ(value_named(problem, mine.best->design, dimension.name),
                  value_named(read.problem, of_file.best->design, dimension.name))
            << dimension.name;
    EXPECT_EQ(value_named(problem, mine.best->design, "ground"), 100);
    EXPECT_NEAR(*value_named(problem, mine.best->design, "swing"), 60 * degree, 1e-9);
    EXPECT_EQ(value_named(problem, mine.best->design, "wing"), std::nullopt);
}

TEST(ByName, APathIsFollowed) {
    Problem problem = problem_of("four-bar");
    for (const char* link : {"ground", "crank", "coupler", "rocker"})
        design_within(problem, link, 10, 100);
    for (const char* coordinate : {"point-along", "point-across", "origin-x", "origin-y"})
        design_within(problem, coordinate, -60, 60);
    design_within(problem, "tilt", -180 * degree, 180 * degree);
    follow_path(problem, {{20, 20}, {20, 25}, {20, 30}, {20, 35}});
    minimize(problem, "path-rms");
    const Result result = solve(problem, {});
    EXPECT_EQ(result.status, Status::solved);
    EXPECT_LT(*value_named(problem, result.best->design, "path-rms"), 1e-6);
}

TEST(ByName, DimensionsHaveAFewValues) {
    Problem problem = crank_rocker();
    choose_among(problem, "crank", {30, 20, 25});
    design_in_steps(problem, "rocker", 20, 301, 2);
    EXPECT_EQ(problem.dimensions[1].choices, (std::vector<double>{20, 25, 30}));
    EXPECT_EQ(problem.dimensions[3].max, 300);
    choose_among(problem, "crank", {30});
    EXPECT_TRUE(problem.dimensions[1].fixed());
}

/// Of all designs with nearly the best transmission angle the shortest.
TEST(ByName, WishesComeBeforeTheObjective) {
    Problem problem = problem_of("four-bar");
    fix(problem, "ground", 100);
    design_within(problem, "crank", 5, 60);
    design_within(problem, "coupler", 20, 300);
    design_within(problem, "rocker", 20, 300);
    require_equal(problem, "swing", 60 * degree);
    minimize(problem, "total-length");
    const Result shortest = solve(problem, {});
    wish_greatest(problem, "transmission-angle-worst", 5 * degree);
    const Result wished = solve(problem, {});
    ASSERT_EQ(wished.status, Status::solved);
    EXPECT_TRUE(wished.verified());
    ASSERT_EQ(wished.best->wished.size(), 1u);
    const MetWish& met = wished.best->wished.front();
    EXPECT_NEAR(met.limit, met.best - 5 * degree, 1e-9);
    EXPECT_NEAR(*value_named(problem, wished.best->design, "transmission-angle-worst"), met.limit, 1e-6);
    EXPECT_LT(*value_named(problem, shortest.best->design, "transmission-angle-worst"), met.limit - degree);
    EXPECT_LT(shortest.best->objective, wished.best->objective - 1);
    wish_least(problem, "link-ratio");
    ASSERT_EQ(problem.wishes.size(), 2u);
    EXPECT_TRUE(problem.wishes[0].term.maximize);
    EXPECT_FALSE(problem.wishes[1].term.maximize);
    EXPECT_EQ(problem.wishes[1].within, 0);
}

template <class Call>
std::string refusal(const Call& call) {
    try {
        call();
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

TEST(ByName, WhatCannotBeMeantIsRefusedWithWhatWouldBeRight) {
    Problem problem = crank_rocker();
    const auto says = [](const std::string& text, const char* part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    says(refusal([] { problem_of("fourbar"); }), "four-bar");
    says(refusal([&] { fix(problem, "crnk", 3); }), "did you mean 'crank'");
    says(refusal([&] { fix(problem, "crank", std::nan("")); }), "finite");
    says(refusal([&] { design_within(problem, "crank", 9, 5); }), "the first must be less");
    says(refusal([&] { design_within(problem, "crank", 5, 9, 10.0); }), "outside its range");
    says(refusal([&] { choose_among(problem, "crank", {}); }), "no choices");
    says(refusal([&] { choose_among(problem, "crank", {3, 4, 3}); }), "twice");
    says(refusal([&] { design_in_steps(problem, "crank", 5, 9, 5); }), "one at least");
    says(refusal([&] { design_in_steps(problem, "crank", 5, 9, -1); }), "must be > 0");
    says(refusal([&] { require_equal(problem, "swng", 1); }), "did you mean 'swing'");
    says(refusal([&] { require_within(problem, "swing", {}, {}); }), "least value");
    says(refusal([&] { minimize(problem, "swing", 0); }), "must be > 0");
    says(refusal([&] { wish_least(problem, "swng"); }), "did you mean 'swing'");
    says(refusal([&] { wish_greatest(problem, "swing", -0.1); }), "must be 0 or greater");
    says(refusal([&] { assemble(problem, "open-ish"); }), "no assembly");
    says(refusal([&] { follow_path(problem, {{1, 2}}); }), "two points");
    Problem shaper = problem_of("crank-shaper");
    says(refusal([&] { follow_path(shaper, {{1, 2}, {3, 4}}); }), "guides no point");
    says(why_not_whole(shaper), "'centre-distance' is missing");
    Problem negative = crank_rocker();
    fix(negative, "ground", -1);
    says(why_not_whole(negative), "greater than 0");
}

}  // namespace
