// What solvers say of their end arrives in words, and what they end at does not depend on it.

#include <atomic>

#include "synthesis/local/local.h"
#include "synthesis/search/starts.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

/// The end of a local search from a start of a shipped problem's first variant.
LocalOutcome end_of_search(const char* folder, const char* name, LocalMethod method, const LocalLimits& limits) {
    const Problem problem = parse_problem(testing::shipped(name, folder), name).problem;
    const Program program = build_program(problem, variants(problem).front());
    return method(program, start_point(program, 1, 0, 16), limits);
}

TEST(Verdicts, OfASearchThatRunsToItsEnd) {
    EXPECT_EQ(end_of_search("quick-return", "shaper-stroke-75.toml", slsqp, {}).verdict, "slsqp: gains too small");
    EXPECT_EQ(end_of_search("quick-return", "shaper-stroke-75.toml", ipopt, {}).verdict, "ipopt: converged");
    EXPECT_EQ(end_of_search("path", "case-1.toml", levenberg_marquardt, {}).verdict, "least-squares: gains too small");
    EXPECT_EQ(end_of_search("four-bar", "transmission-not-reachable.toml", ipopt, {}).verdict,
              "ipopt: locally infeasible");
}

TEST(Verdicts, OfASearchThatIsCutOff) {
    const std::atomic<bool> stop = true;
    LocalLimits few, stopped;
    few.most_evaluations = 2;
    stopped.stop = &stop;
    for (const auto& [name, method] : {std::pair("slsqp", &slsqp), std::pair("ipopt", &ipopt)}) {
        EXPECT_EQ(end_of_search("quick-return", "shaper-stroke-75.toml", method, few).verdict,
                  std::string(name) + ": evaluations used up");
        EXPECT_EQ(end_of_search("quick-return", "shaper-stroke-75.toml", method, stopped).verdict,
                  std::string(name) + ": stopped");
    }
    EXPECT_EQ(end_of_search("path", "case-1.toml", levenberg_marquardt, few).verdict,
              "least-squares: evaluations used up");
    EXPECT_EQ(end_of_search("path", "case-1.toml", levenberg_marquardt, stopped).verdict, "least-squares: stopped");
}

/// NLopt 2.7.1 would go by memory that was never set there.
TEST(Verdicts, OfASearchThatBeginsWhereNothingAssembles) {
    const Problem problem = parse_problem(testing::shipped("case-1.toml", "path"), "case-1.toml").problem;
    const Program program = build_program(problem, variants(problem).front());
    Eigen::VectorXd x = start_point(program, 1, 0, 16);
    for (std::size_t i = 0; i < program.size(); ++i)
        if (program.variables[i].name == "coupler" || program.variables[i].name == "rocker")
            x[static_cast<Eigen::Index>(i)] = program.variables[i].lower;
    ProgramValues values;
    evaluate(program, x, false, values);
    ASSERT_FALSE(values.assembled);
    const LocalOutcome outcome = slsqp(program, x, {});
    EXPECT_EQ(outcome.verdict, "slsqp: not assembled");
    EXPECT_EQ(outcome.x.size(), 0);
    EXPECT_EQ(outcome.evaluations, 1);
}

}  // namespace

}  // namespace mechwright
