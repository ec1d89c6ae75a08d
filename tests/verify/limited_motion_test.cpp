// Motions that end: cranks that do not turn fully, whose ends are dead positions, and ranges in which a mechanism comes
// apart.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "synthesis/document/document.h"
#include "synthesis/mechanism/stationary.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"
#include "tests/verify/documents.h"

namespace mechwright {

namespace {

using namespace test;

Problem given(const std::string& text) {
    const ReadProblem read = parse_problem("schema = 1\n" + text, "given.toml");
    for (const Message& m : read.messages)
        ADD_FAILURE() << to_string(m);
    return read.problem;
}

/// Checks that fail of a design of which all is given.
std::vector<std::string> failures_of(const Problem& problem) {
    return failures(analysis_document(problem, evaluate_given(problem)));
}

// Short of a change point by 1e-12 of its size, this linkage comes apart over 3e-4 deg, and by less than rounding
// there.
TEST(LimitedMotion, OfAllButAFullTurnIsWhole) {
    const Problem problem = given(R"(mechanism = "four-bar"
[dimensions]
ground = 129.13992998634518
crank = 27.428971521634132
coupler = 43.575774042489066
rocker = 145.2867325073606
)");
    EXPECT_EQ(failures_of(problem), std::vector<std::string>{});
}

TEST(LimitedMotion, OfASliderCrankIsStatedAsItIsMeasuredAgain) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> length(1, 60), offset(-60, 60);
    int limited = 0;
    while (limited < 60) {
        const double crank = length(random), rod = length(random), e = offset(random);
        if (crank + std::abs(e) < rod || std::abs(e) - crank > rod) continue;
        ++limited;
        const Problem problem = given(fmt::format(
            "mechanism = \"slider-crank\"\n[dimensions]\ncrank = {}\nrod = {}\noffset = {}\n", crank, rod, e));
        EXPECT_TRUE(failures_of(problem).empty()) << crank << ' ' << rod << ' ' << e << '\n'
                                                  << told(verify(analysis_document(problem, evaluate_given(problem))));
    }
}

TEST(LimitedMotion, OfADragLinkIsStatedAsItIsMeasuredAgain) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> length(20, 90), angle(-180, 180);
    int limited = 0;
    for (int tried = 0; tried < 400 && limited < 25; ++tried) {
        const Problem problem = given(fmt::format(
            "mechanism = \"drag-link\"\n[dimensions]\nground = {}\ncrank = {}\ncoupler = {}\nfollower = {}\narm = "
            "{}\narm-angle = {}\nrod = 400\nslide-angle = {}\nslide-offset = 0\n",
            length(random), length(random), length(random), length(random), length(random), angle(random),
            angle(random)));
        const Design design = evaluate_given(problem).design;
        const Motion motion = motion_of(problem, design);
        if (motion.full_turn || !(motion.from < motion.to)) continue;
        ++limited;
        EXPECT_TRUE(failures_of(problem).empty()) << told(verify(analysis_document(problem, evaluate_given(problem))));
    }
    EXPECT_EQ(limited, 25);
}

TEST(LimitedMotion, EndsWhereTheRamIsInfinitelyFast) {
    const Problem problem = given("mechanism = \"slider-crank\"\n[dimensions]\ncrank = 50\nrod = 30\noffset = 10\n");
    const Json quantities = analysis_document(problem, evaluate_given(problem))["quantities"];
    EXPECT_FALSE(quantities.contains("ram-speed-max"));
    EXPECT_FALSE(quantities.contains("ram-acceleration-max"));
    // From the dead position with sine -20/50 of the crank angle, its crank pointing back, to the crank folded onto the
    // rod.
    EXPECT_EQ(quantities["transmission-angle-min"], 0);
    ASSERT_TRUE(quantities.contains("stroke"));
    EXPECT_NEAR(quantities["stroke"].get<double>(), std::sqrt(50.0 * 50 - 20 * 20) - std::sqrt(20.0 * 20 - 10 * 10),
                1e-12);
}

TEST(LimitedMotion, ZerosAreSoughtWhereAFunctionHasValues) {
    const auto broken = [](double x) { return x > 0.3 && x < 0.4 ? std::nan("") : x - 0.5; };
    const double zero = detail::zero_between_signs(broken, 0.0, 1.0, -0.5, 0.5, 1e-12);
    EXPECT_NEAR(zero, 0.5, 1e-9);
    const double nan = std::nan("");
    for (const auto& [a, b] : {std::pair{nan, 1.0}, {-1.0, nan}, {1.0, 2.0}, {-INFINITY, 1.0}})
        EXPECT_EQ(detail::zero_between_signs(broken, 0.0, 1.0, a, b, 1e-12), 0.5);
    const auto root = [](double x) { return std::sqrt(x - 0.2) - 0.3; };  // nothing below 0.2
    const auto brackets = brackets_of_zeros(root, sample_angles({0, 1}));
    ASSERT_EQ(brackets.size(), 1u);
    EXPECT_LE(brackets[0].left, 0.29);
    EXPECT_GE(brackets[0].right, 0.29);
}

TEST(LimitedMotion, OfAPathInAnyOrderIsVerified) {
    // A crank that swings between dead positions; its ends are no places of the curve but for rounding.
    const Problem problem = given(
        "mechanism = \"slider-crank\"\n[dimensions]\ncrank = 59.49955\nrod = 5.9716122\noffset = -53.665858\n"
        "point-along = -0.25787865\npoint-across = -8.8775899\norigin-x = -10.32093\norigin-y = -60\ntilt = 144.2919\n"
        "[path]\npoints = [[0.0, 0.0199], [4.0, 4.6686], [8.0, 5.8526], [12.0, 2.8856], [16.0, -2.2481], [20.0, "
        "-5.7209]]\ntiming = \"none\"\n[objective]\nminimize = \"path-rms\"\n");
    const Result result = solve(problem, {});
    EXPECT_EQ(result.status, Status::solved) << told(result.verification);
}

// It assembles at both ends of the range and not between.
constexpr const char* hole =
    "mechanism = \"four-bar\"\n[motion]\ncrank_range = [-40, 30]\n[dimensions]\nground = 100\ncrank = 60\n"
    "coupler = 150\nrocker = 95\n";

TEST(RangeWithAHole, GivesNothingAValue) {
    const Problem problem = given(std::string(hole) + "[[require]]\nquantity = \"velocity-ratio-max\"\nmax = 100\n");
    const Solution solution = evaluate_given(problem);
    EXPECT_FALSE(solution.feasible);
    for (std::size_t i = 0; i < problem.mechanism->quantities.size(); ++i)
        EXPECT_FALSE(quantity_value(problem, i, solution.design)) << problem.mechanism->quantities[i].name;
    EXPECT_EQ(solve(problem, {}).status, Status::infeasible);
}

TEST(RangeWithAHole, IsInfeasibleWithoutARequirementToo) {
    const Problem problem = given(hole);
    EXPECT_FALSE(evaluate_given(problem).feasible);
    EXPECT_EQ(solve(problem, {}).status, Status::infeasible);
}

TEST(RangeWithAHole, IsNotBelievedByVerification) {
    std::string whole = hole;
    whole.replace(whole.find("[-40, 30]"), 9, "[30, 40]");
    const Problem problem = given(whole + "[[require]]\nquantity = \"velocity-ratio-max\"\nmax = 100\n");
    Json json = analysis_document(problem, evaluate_given(problem));
    EXPECT_TRUE(failures(json).empty()) << told(verify(json));
    json["crank_range"] = {-40, 30};
    const auto failed = failures(json);
    EXPECT_TRUE(std::find(failed.begin(), failed.end(), "velocity-ratio-max is at most 100") != failed.end())
        << told(verify(json));
}

TEST(RangeWithAHole, IsNoAnswerOfASearch) {
    const Problem problem = given(
        "mechanism = \"four-bar\"\n[motion]\ncrank_range = [-44.03795852986502, 30.951771008612184]\n[dimensions]\n"
        "ground = 100.0\ncrank = { min = 20.0, max = 150.0 }\ncoupler = { min = 20.0, max = 300.0 }\n"
        "rocker = { min = 20.0, max = 300.0 }\n[[require]]\nquantity = \"velocity-ratio-max\"\n"
        "max = 1.1767461176892946\n[[require]]\nquantity = \"velocity-ratio-min\"\nmin = 0.334004971977756\n"
        "[objective]\nmaximize = \"transmission-angle-worst\"\n[solver]\nstarts = 12\n");
    EXPECT_EQ(solve(problem, {}).status, Status::infeasible);
}

}  // namespace

}  // namespace mechwright
