#include "synthesis/report/text/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>

#include "synthesis/program/assess.h"
#include "synthesis/program/proof.h"
#include "synthesis/report/text/table.h"
#include "tests/report/examples.h"

namespace mechwright {
namespace {

using namespace testing;

void expect_readable(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(width_of(line), terminal_width) << line;
        EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    }
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_EQ(text.find("\n\n\n"), std::string::npos) << text;
    EXPECT_EQ(text.back(), '\n');
}

void expect_has(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n--- is not in\n" << text;
}

void expect_has_not(const std::string& text, const std::string& part) {
    EXPECT_EQ(text.find(part), std::string::npos) << part << "\n--- is in\n" << text;
}

TEST(Summary, OfASolvedProblem) {
    Problem problem = problem_of(crank_rocker_text);
    problem.requirements[0].equal = 61.41306198 * 3.141592653589793 / 180;
    problem.solver.tolerance = 1e-6;
    Solution solution = crank_rocker_solution();
    solution.feasible = true;
    Result result = result_of(Status::solved, solution);
    result.alternatives = {{solution, {}}, {solution, {}}};
    const std::string text = summary(problem, result, {});
    expect_readable(text);
    for (const char* part :
         {"Crank-rocker of 60 deg swing", "four-bar from example.toml", "Solved: all requirements are met",
          "Design: crank-rocker, open assembly", "ground   100.0  mm   given", "crank     40.0  mm",
          "at its upper limit 81.8", "tilt      30    deg  given", "Objective: maximize transmission-angle-worst",
          "39.71 deg", "swing", "met, 9.71 to spare", "Verification: all 2 checks passed",
          "Search: search: 32 starts, 3 local optima", "20 starts ended at the best one", "1.5%", "1234 evaluations",
          "2 other designs, the next best with objective 39.71"})
        expect_has(text, part);
    expect_has_not(text, "missed by");
    expect_has_not(text, "\x1b");
}

/// A range may go on to where nobody looks: its other end says nothing about how close a value is to this one.
TEST(Summary, NamesALimitOnlyWhereTheDesignIsAtIt) {
    Problem problem = problem_of(crank_rocker_text);
    for (DimensionRange& range : problem.dimensions)
        if (!range.fixed()) range.max = 1e12;
    const std::string text = summary(problem, result_of(Status::solved, crank_rocker_solution()), {});
    expect_has_not(text, "at its");
}

TEST(Summary, OfAnInfeasibleProblemNamesTheObstacle) {
    Result result = result_of(Status::infeasible, crank_rocker_solution());
    result.verification.clear();
    const std::string text = summary(problem_of(crank_rocker_text), result, {});
    expect_readable(text);
    expect_has(text, "Infeasible: no design that meets all requirements was found");
    expect_has(text, "not a proof");
    expect_has(text, "It fails most at swing, which has to be 60");
    expect_has(text, "missed by 1.413");

    result.search.proof = proof_by("the cubic has no root in the range", CountCertificate{});
    const std::string proven = summary(problem_of(crank_rocker_text), result, {});
    expect_readable(proven);
    expect_has(proven, "Infeasible: it is proven that no design meets all requirements.");
    expect_has(proven, "complete: the cubic has no root in the range.");
    expect_has_not(proven, "not a proof");
}

TEST(Summary, SaysAtLeastAndAtMost) {
    Problem problem = problem_of(crank_rocker_text);
    problem.requirements.erase(problem.requirements.begin());
    problem.requirements[0].min = 1.2;
    expect_has(summary(problem, result_of(Status::infeasible, crank_rocker_solution()), {}), "has to be at least");
    problem.requirements[0].min = 0.1;
    problem.requirements[0].max = 0.2;
    expect_has(summary(problem, result_of(Status::infeasible, crank_rocker_solution()), {}), "has to be at most");
}

TEST(Summary, OfADesignThatDoesNotAssemble) {
    Solution apart = crank_rocker_solution();
    apart.design.dimensions = {100, 10, 20, 30, 0, 0, 0, 0, 0};
    apart.objective = std::nan("");
    const std::string text = summary(problem_of(crank_rocker_text), result_of(Status::infeasible, apart), {});
    expect_readable(text);
    expect_has(text, "not defined");
    expect_has(text, "It does not assemble.");
    expect_has(text, "  not defined\n");
}

TEST(Summary, OfAFailedVerificationShowsOnlyWhatFailed) {
    Result result = result_of(Status::unverified, path_solution());
    result.verification[1].passed = false;
    result.verification[1].detail = "point 3 is met before point 2";
    const std::string text = summary(problem_of(path_text), result, {});
    expect_readable(text);
    expect_has(text, "Unverified: a design was found, but its verification failed.");
    expect_has(text, "Verification: 1 of 2 checks FAILED");
    expect_has(text, "failed  swing: point 3 is met before point 2");
    expect_has_not(text, "assembles over");
}

TEST(Summary, OfAnEarlyEnd) {
    Result result = result_of(Status::limit, path_solution());
    result.note = "The time limit of 60 s was reached.";
    const std::string limit = summary(problem_of(path_text), result, {});
    expect_readable(limit);
    expect_has(limit,
               "Limit: stopped before the search ended; this is the best design so far.\nThe time limit of 60 s");
    result.status = Status::interrupted;
    result.best->feasible = false;
    result.best->violation = 0.125;
    const std::string interrupted = summary(problem_of(path_text), result, {});
    expect_readable(interrupted);
    expect_has(interrupted, "Interrupted: stopped on request; no design so far meets all requirements");
    expect_has(interrupted, "0.125 (relative)");
    result.best.reset();
    const std::string nothing = summary(problem_of(path_text), result, {});
    expect_readable(nothing);
    expect_has(nothing, "no design was found so far");
    expect_has_not(nothing, "Design:");
}

TEST(Summary, ShowsFewPathPointsAndNotMany) {
    Problem problem = problem_of(path_text);
    Solution solution = path_solution();
    const std::string few = summary(problem, result_of(Status::solved, solution), {});
    expect_readable(few);
    expect_has(few, "Path: 3 points\n");
    expect_has(few, "reached x");
    expect_has(few, "distance: root mean square");
    problem.path->points.assign(13, {30, 30});
    problem.path->weights.assign(13, 1);
    solution.design.path_angles.assign(13, 0.5);
    const std::string many = summary(problem, result_of(Status::solved, solution), {});
    expect_readable(many);
    expect_has(many, "Path: 13 points\n");
    expect_has_not(many, "reached x");
    expect_has(many, "distance: root mean square");
}

TEST(Summary, ObjectivesOfSeveralTerms) {
    Problem problem = problem_of(crank_rocker_text);
    const auto index = [&](std::string_view name) {
        return static_cast<std::size_t>(find_quantity(*problem.mechanism, name));
    };
    problem.objective = Objective{{{index("total-length"), false, 2}, {index("velocity-ratio-max"), true, 1}}, false};
    Result result = result_of(Status::solved, crank_rocker_solution());
    result.best->objective = 627.5;
    const std::string sum = summary(problem, result, {});
    expect_readable(sum);
    expect_has(sum, "Objective: a weighted sum");
    expect_has(sum, "weight 2");
    expect_has(sum, "sum: 627.5");
    problem.objective->worst = true;
    expect_has(summary(problem, result, {}), "Objective: the worst of several");
}

TEST(Summary, ShowsWhatComesBeforeTheObjective) {
    Problem problem = problem_of(crank_rocker_text);
    problem.wishes.push_back(
        {{static_cast<std::size_t>(find_quantity(*problem.mechanism, "total-length")), false, 1}, 20});
    Result result = result_of(Status::solved, crank_rocker_solution());
    const std::string never_searched = summary(problem, result, {});
    expect_readable(never_searched);
    expect_has(never_searched, "minimize  total-length    314.2");
    result.best->wished = {{300.5, 320.5}};
    const std::string text = summary(problem, result, {});
    expect_readable(text);
    expect_has(text, "First, in this order");
    expect_has(text, "314.2  mm  300.5    320.5");
    expect_has_not(summary(problem_of(crank_rocker_text), result, {}), "First, in this order");
}

TEST(Summary, SaysWhatIsLeftOfAllowedValues) {
    const Problem problem = problem_of(crank_rocker_text);
    Result result = result_of(Status::solved, crank_rocker_solution());
    const auto expect_says = [&](const DiscreteReport& discrete, const std::string& part) {
        result.search.discrete = discrete;
        const std::string text = summary(problem, result, {});
        expect_readable(text);
        const std::string unfolded = std::regex_replace(text, std::regex("\\s+"), " ");
        expect_has(unfolded, "Branch and bound over the allowed values, ");
        expect_has(unfolded, part);
    };
    expect_says({.problems = 1}, "1 problem; no allowed values are left that could be better");
    expect_says({.problems = 7, .continuous = 41.25},
                "7 problems: 41.25 could be had with any values of the ranges; no");
    expect_says({.problems = 7, .gap = 0.5}, "allowed values that were not looked at may be better by 0.5.");
    expect_says({.problems = 7, .combinations = 24}, "all of their 24 combinations were looked at.");
    expect_says({.problems = 7, .left_out = 1}, "1 part of them was left out because");
    expect_says({.problems = 7, .left_out = 2}, "2 parts of them were left out because");
}

TEST(Summary, SaysHowFarTheRangeOfUseGoesBeyondTheTargets) {
    const std::string use = "[motion]\nfrom = \"first-target\"\nto = \"last-target\"\n";
    const auto said = [&](const std::string& margins) {
        const std::string text =
            summary(problem_of(path_text + use + margins), result_of(Status::solved, path_solution()), {});
        expect_readable(text);
        return std::regex_replace(text, std::regex("\\s+"), " ");
    };
    expect_has(said(""), "; from the first target to the last.");
    expect_has(said("before = 5\n"), "; from 5 deg before the first target to the last.");
    expect_has(said("after = 2.5\n"), "; from the first target to 2.5 deg after the last.");
}

TEST(Summary, ColoursOnRequest) {
    const Result result = result_of(Status::solved, path_solution());
    expect_has(summary(problem_of(path_text), result, {.colour = true}), "\x1b[1;32mSolved:\x1b[0m all requirements");
    expect_has_not(summary(problem_of(path_text), result, {}), "\x1b");
}

TEST(Summary, TextOfTheFileCannotCommandTheTerminal) {
    Problem problem = problem_of(path_text);
    problem.title = "evil \x1b[2J title";
    problem.file = "evil\x1b.toml";
    problem.units.length = "m\x1bm";
    expect_has_not(summary(problem, result_of(Status::solved, path_solution()), {}), "\x1b");
}

TEST(Summary, LongTitlesFold) {
    Problem problem = problem_of(path_text);
    problem.title.clear();
    for (int i = 0; i < 30; ++i)
        problem.title += "Übertragungswinkel ";
    expect_readable(summary(problem, result_of(Status::solved, path_solution()), {}));
}

TEST(AnalysisSummary, ListsQuantitiesAndMotion) {
    const std::string text = analysis_summary(problem_of(crank_rocker_text), crank_rocker_solution(), {.digits = 10});
    expect_readable(text);
    for (const char* part : {"Design: crank-rocker", "The crank turns fully.", "Quantities", "time-ratio", "1.2033",
                             "swing", "61.41306198", "deg", "total-length", "314.2", "missed by 1.413"})
        expect_has(text, part);
    for (const char* part : {"Solved", "Search", "Verification"})
        expect_has_not(text, part);
}

TEST(AnalysisSummary, CamsHaveNoCrank) {
    const Problem problem = problem_of(R"(schema = 1
mechanism = "cam"
[cam]
follower = "knife"
[dimensions]
prime-radius = 40
offset = 0
[[segment]]
kind = "rise"
angle = 180
lift = 10
law = "cycloidal"
[[segment]]
kind = "return"
angle = 180
lift = 10
law = "cycloidal"
)");
    const std::string text = analysis_summary(problem, evaluate_given(problem), {});
    expect_has(text, "pressure-angle");
    expect_has_not(text, "crank");
}

TEST(AnalysisSummary, SaysHowFarTheCrankTurns) {
    Problem problem = problem_of(crank_rocker_text);
    problem.crank_range = {0.5235987755982988, 3.141592653589793};
    expect_has(analysis_summary(problem, crank_rocker_solution(), {}), "Motion: crank angles from 30 deg to 180 deg.");
    Solution apart = crank_rocker_solution();
    apart.design.dimensions = {100, 10, 20, 30, 0, 0, 0, 0, 0};
    expect_has(analysis_summary(problem_of(crank_rocker_text), apart, {}), "does not assemble at any crank angle");
}

}  // namespace
}  // namespace mechwright
