// Shipped problems by two methods that share nothing but the program: the same objective to 1e-8.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "synthesis/bench/agreement/answer.h"
#include "synthesis/bench/shipped.h"
#include "tests/long_form.h"

namespace mechwright {

namespace {

struct Pair {
    const char* problem;
    const char* method;  ///< besides the one that the file asks for
};

class TwoMethods : public ::testing::TestWithParam<Pair> {};

TEST_P(TwoMethods, ComeToTheSameAnswer) {
    const Pair& pair = GetParam();
    auto problem = bench::shipped_problem(MECHWRIGHT_SOURCE_DIR "/problems", pair.problem);
    ASSERT_TRUE(problem.has_value());
    problem->solver.starts = std::min(problem->solver.starts, cases_to_try(8, problem->solver.starts));
    RunOptions options;
    options.jobs = 2;
    const bench::Answer first = bench::answer_of(*problem, problem->solver.method, options);
    const bench::Answer second = bench::answer_of(*problem, pair.method, options);
    EXPECT_NE(first.kind, bench::AnswerKind::none);
    EXPECT_NE(first.method, second.method);
    EXPECT_LE(bench::difference(first, second), bench::agree_within);
}

INSTANTIATE_TEST_SUITE_P(
    Shipped, TwoMethods,
    ::testing::Values(Pair{"cam/flat-cycloidal", "slsqp"}, Pair{"cam/flat-harmonic", "slsqp"},
                      Pair{"cam/composed-motion", "ipopt"}, Pair{"cam/roller-equal-limits", "slsqp"},
                      Pair{"cam/roller-harmonic", "slsqp"}, Pair{"cam/roller-offset", "slsqp"},
                      Pair{"cam/roller-undercut", "slsqp"}, Pair{"cam/roller-uneven", "slsqp"},
                      Pair{"cam/tangent-spring", "ipopt"}, Pair{"cam/valve-from-lift", "ipopt"},
                      Pair{"exact/extreme-velocity-ratio", "slsqp"}, Pair{"line/dwell", "ipopt"},
                      Pair{"function/logarithm-compact", "ipopt"}, Pair{"four-bar/best-transmission", "ipopt"},
                      Pair{"four-bar/crank-rocker", "slsqp"}, Pair{"four-bar/crank-rocker", "ipopt"},
                      Pair{"four-bar/crank-rocker-compact", "ipopt"},
                      Pair{"four-bar/drag-link-velocity-ratio", "exact"},
                      Pair{"four-bar/transmission-not-reachable", "slsqp"}, Pair{"function/power-rms", "ipopt"}),
    [](const auto& test) {
        std::string name = std::string(test.param.problem) + "_" + test.param.method;
        std::replace_if(
            name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
        return name;
    });

}  // namespace

}  // namespace mechwright
