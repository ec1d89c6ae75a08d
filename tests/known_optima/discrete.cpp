// Dimensions with a few allowed values, against all their combinations counted out.

#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>

#include "synthesis/problem/allowed_values.h"
#include "synthesis/verify/verify.h"
#include "tests/known_optima/solved.h"

namespace mechwright::testing {

namespace {

constexpr double degree = std::numbers::pi / 180;

struct Links {
    double ground, crank, coupler, rocker;
};

/// The angle between two sides of a triangle, opposite the third; nothing where there is no triangle.
std::optional<double> angle_between(double a, double b, double opposite) {
    const double cosine = (a * a + b * b - opposite * opposite) / (2 * a * b);
    return std::abs(cosine) <= 1 ? std::optional(std::acos(cosine)) : std::nullopt;
}

/// The least transmission angle of a crank-rocker with the swing and the time ratio of the shipped problem, by its
/// triangles at the dead centres and where the crank is in line with the ground link.
std::optional<double> transmission_of(const Links& l) {
    const auto [g, a, c, r] = l;
    const double longest = std::max({g, c, r}), shortest = std::min({g, c, r});
    const double others = g + c + r - longest - shortest;
    if (a >= shortest || a + longest >= shortest + others) return {};
    const auto far = angle_between(g, r, c + a), near = angle_between(g, r, c - a);
    const auto crank_far = angle_between(g, c + a, r), crank_near = angle_between(g, c - a, r);
    if (!far || !near || !crank_far || !crank_near) return {};
    const double swing = std::abs(*far - *near) / degree, lag = std::abs(*crank_far - *crank_near) / degree;
    if (swing < 55 || swing > 65 || (180 + lag) / (180 - lag) < 1.1) return {};
    const double narrow = *angle_between(c, r, g - a), wide = *angle_between(c, r, g + a);
    return std::min({narrow, std::numbers::pi - narrow, wide, std::numbers::pi - wide}) / degree;
}

TEST(Discrete, LinksFromStockAreTheBestOfAllCombinations) {
    double best = 0;
    for (const double ground : {80.0, 100.0, 120.0, 140.0})
        for (double crank = 20; crank <= 60; crank += 5)
            for (double coupler = 60; coupler <= 200; coupler += 5)
                for (double rocker = 40; rocker <= 150; rocker += 5)
                    best = std::max(best, transmission_of({ground, crank, coupler, rocker}).value_or(0));
    const Solved s = solved(shipped("links-from-stock.toml"));
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.result.best->objective, best, 1e-10);
    ASSERT_TRUE(s.result.search.discrete);
    EXPECT_EQ(s.result.search.discrete->gap, 0);
    EXPECT_GT(*s.result.search.discrete->continuous, best);
    for (const VerifiedDesign& other : s.result.alternatives)
        for (std::size_t i = 0; i < 4; ++i) {
            const double value = other.solution.design.dimensions[i];
            EXPECT_EQ(value, nearest_allowed(s.problem.dimensions[i], value));
        }
}

TEST(Discrete, TheGapOfARunThatIsStoppedHoldsWhatWasNotLookedAt) {
    constexpr double best = 47.45933118469001;  // of all combinations, see above
    ReadProblem read = parse_problem(shipped("links-from-stock.toml"), "links-from-stock.toml");
    int with_design = 0;
    for (const int problems : {3, 6, 12, 20, 30, 40}) {
        std::atomic<bool> stop = false;
        RunOptions options;
        options.stop = &stop;
        options.progress = [&](int done, int, double) { stop = stop || done >= problems; };
        const Result result = solve(read.problem, options);
        EXPECT_EQ(result.status, Status::interrupted);
        if (!result.best || !result.best->feasible) continue;  // none was found so soon
        ++with_design;
        EXPECT_GE(result.best->objective + result.search.discrete->gap, best - 1e-9) << problems;
    }
    EXPECT_GE(with_design, 3);
}

/// Four choices of lengths, with a narrow range of swing: searches among any values of the ranges end where no allowed
/// ones are near.
std::string of_narrow_swing(const std::array<std::string, 4>& choices, double from, double to) {
    std::string text = "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\n";
    const std::array<std::string, 4> links{"ground", "crank", "coupler", "rocker"};
    for (std::size_t i = 0; i < 4; ++i)
        text += links[i] + " = { choices = [" + choices[i] + "] }\n";
    return text + "[[require]]\nquantity = \"swing\"\nmin = " + std::to_string(from) + "\nmax = " + std::to_string(to) +
           "\n[objective]\nminimize = \"total-length\"\n";
}

TEST(Discrete, NoCombinationIsLeftOutWhereSearchesFindNothing) {
    const Solved a = solved(of_narrow_swing({"118, 123, 130", "17, 18, 25, 29", "45, 83, 113, 131", "82, 112, 139"},
                                            24.2011359, 24.7786530));
    ASSERT_EQ(a.result.status, Status::solved);
    EXPECT_NEAR(a.result.best->objective, 335, 1e-9);
    EXPECT_EQ(a.result.search.discrete->combinations, 3 * 4 * 4 * 3);
    EXPECT_EQ(a.result.search.discrete->left_out, 0);
    const Solved b = solved(of_narrow_swing({"96, 128", "20, 25", "80, 100", "81, 90"}, 30.2, 30.4));
    ASSERT_EQ(b.result.status, Status::solved);
    EXPECT_NEAR(b.result.best->objective, 309, 1e-9);
}

TEST(Discrete, ChangePointsAreNoChoice) {
    // 75, 51, 65, 89 has the same total length, and its links fall into one line.
    const Solved s =
        solved(of_narrow_swing({"75, 82", "50, 51", "65, 75, 85", "80, 89, 104"}, 87.60111752778, 91.46158015850592));
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.result.best->objective, 280, 1e-9);
    EXPECT_NEAR(s.dimension("crank"), 50, 1e-12);
}

TEST(Discrete, WhatComesClosestIsAllowed) {
    const std::string text =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = { choices = [20, 30] }\n"
        "coupler = { choices = [50, 90] }\nrocker = { choices = [40, 60, 80] }\n[[require]]\n"
        "quantity = \"swing\"\nequal = 45\n[objective]\nmaximize = \"transmission-angle-worst\"\n";
    const Solved s = solved(text);
    EXPECT_EQ(s.result.status, Status::infeasible);
    ASSERT_TRUE(s.result.best);
    // With 90 and 80 the swing is 45.95 deg; every other crank-rocker is farther off.
    EXPECT_NEAR(s.dimension("crank"), 30, 1e-12);
    EXPECT_NEAR(s.dimension("coupler"), 90, 1e-12);
    EXPECT_NEAR(s.dimension("rocker"), 80, 1e-12);
}

TEST(Discrete, TheRestIsDesignedForEachChoice) {
    // With the crank given the closed form of swing and time ratio leaves no number open: the best of three.
    const std::string rest =
        "coupler = { min = 20, max = 300 }\nrocker = { min = 20, max = 300 }\n[[require]]\nquantity = \"swing\"\n"
        "equal = 60\n[[require]]\nquantity = \"time-ratio\"\nequal = 1.1\n"
        "[objective]\nmaximize = \"transmission-angle-worst\"\n";
    const std::string head = "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = ";
    double best = 0;
    for (const char* crank : {"25", "30.5", "36"}) {
        const Solved one = solved(head + crank + "\n" + rest);
        if (one.result.status == Status::solved) best = std::max(best, one.result.best->objective);
    }
    ASSERT_GT(best, 0);
    const Solved s = solved(head + "{ choices = [36, 25, 30.5] }\n" + rest);
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.result.best->objective, best, 1e-7);
}

TEST(Discrete, AnglesHaveChoicesInTheUnitOfTheFile) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"linkage\"\n[dimensions]\ncrank = 30\nangle = { choices = [20, 50, 35] }\n"
        "[links]\nframe = { A = [0, 0], D = [100, 0] }\n"
        "crank = { A = [0, 0], B = [\"crank\", 0] }\nrod = { B = [0, 0], C = [90, 0], "
        "P = { length = 40, angle = \"angle\" } }\nrocker = { D = [0, 0], C = [70, 0] }\n"
        "[drive]\nlink = \"crank\"\n[signals]\ny = { y = \"P\" }\n[objective]\nmaximize = \"y.greatest\"\n");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.dimension("angle"), 50 * degree, 1e-15);
}

TEST(Discrete, WhatIsTiedFollowsTheChoice) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = { min = 20, max = 40, step = 7 }\n"
        "coupler = { of = \"crank\", times = 3 }\nrocker = { min = 50, max = 120 }\n"
        "[[require]]\nquantity = \"swing\"\nmin = 40\n[objective]\nmaximize = \"transmission-angle-worst\"\n");
    ASSERT_EQ(s.result.status, Status::solved);
    const double crank = s.dimension("crank");
    EXPECT_EQ(crank, nearest_allowed(s.problem.dimensions[1], crank));
    EXPECT_EQ(s.dimension("coupler"), 3 * crank);
    EXPECT_EQ(s.problem.dimensions[1].max, 34);
}

TEST(Discrete, WhatNoChoiceMeetsIsNotFound) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = { choices = [20, 30] }\n"
        "coupler = { choices = [70, 90] }\nrocker = { choices = [60, 80] }\n"
        "[[require]]\nquantity = \"swing\"\nequal = 47\n");
    EXPECT_EQ(s.result.status, Status::infeasible);
    EXPECT_EQ(s.result.search.proof, nullptr);
    ASSERT_TRUE(s.result.best);
    for (std::size_t i = 1; i < 4; ++i) {
        const double value = s.result.best->design.dimensions[i];
        EXPECT_EQ(value, nearest_allowed(s.problem.dimensions[i], value));
    }
}

TEST(Discrete, AnyOfTheChoicesWillDoWhereNothingIsOptimised) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = { choices = [20, 30] }\n"
        "coupler = { min = 70, max = 95, step = 0.5 }\nrocker = { min = 50, max = 100 }\n"
        "[[require]]\nquantity = \"swing\"\nequal = 47\n");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.value("swing"), 47 * degree, 1e-8);
}

TEST(Discrete, AllowedValuesFollowEachOther) {
    DimensionRange steps{0.1, 0.7, {}, true};
    steps.step = 0.1;
    for (int i = 0; i <= 6; ++i) {
        const double value = i == 6 ? 0.7 : 0.1 + i * 0.1;
        EXPECT_EQ(nearest_allowed(steps, value + 0.04), value);
        EXPECT_EQ(nearest_allowed(steps, value - 0.04), value);
        const auto [below, above] = allowed_around(steps, value);
        EXPECT_EQ(i == 6 ? above : below, value);
        EXPECT_NEAR(above - below, 0.1, 1e-15);
    }
    EXPECT_EQ(allowed_around(steps, -3).first, 0.1);
    EXPECT_EQ(allowed_around(steps, 3).second, 0.7);
    DimensionRange choices{1, 9, {}, true};
    choices.choices = {1, 2, 9};
    EXPECT_EQ(allowed_around(choices, 2), std::pair(2.0, 9.0));
    EXPECT_EQ(allowed_around(choices, 9), std::pair(2.0, 9.0));
    EXPECT_EQ(allowed_around(choices, 1.5), std::pair(1.0, 2.0));
    EXPECT_EQ(allowed_between(choices, 2, 9).choices, (std::vector<double>{2, 9}));
    EXPECT_FALSE(allowed_between(choices, 9, 9).discrete());
}

TEST(Discrete, AValueThatIsNotAllowedIsNotVerified) {
    const Solved s = solved(shipped("links-from-stock.toml"));
    nlohmann::ordered_json right = document(s.problem, s.result);
    ASSERT_TRUE(all_passed(verify(right)));
    for (const auto& [name, value] : {std::pair("ground", 101.0), std::pair("crank", 31.0)}) {
        nlohmann::ordered_json wrong = right;
        wrong["design"][name] = value;
        bool noticed = false;
        for (const Check& check : verify(wrong))
            noticed = noticed || (check.name == "dimensions are as given and within their ranges" && !check.passed &&
                                  check.detail.find(name) != std::string::npos);
        EXPECT_TRUE(noticed) << name;
    }
}

}  // namespace

}  // namespace mechwright::testing
