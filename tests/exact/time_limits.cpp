// Exact methods end where the time limit or a stop says so, with what was found until then.

#include <atomic>
#include <ctime>

#include "synthesis/solve/solve.h"
#include "tests/known_optima/solved.h"

namespace mechwright::testing {

namespace {

/// Seconds of the processor's time, which does not depend on what else runs.
double worked() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Ended {
    Result result;
    double seconds;
};

Ended ended(const std::string& text, double time_limit, const std::atomic<bool>* stop) {
    ReadProblem read = parse_problem(text, MECHWRIGHT_SOURCE_DIR "/problems/exact/problem-of-a-test.toml");
    for (const Message& m : read.messages)
        ADD_FAILURE() << to_string(m);
    read.problem.solver.method = "exact";
    read.problem.solver.time_limit = time_limit;
    RunOptions options;
    options.stop = stop;
    const double begin = worked();
    Ended out{solve(read.problem, options), 0};
    out.seconds = worked() - begin;
    return out;
}

class TimeLimits : public ::testing::TestWithParam<const char*> {};

TEST_P(TimeLimits, AreKept) {
    const Ended e = ended(shipped(GetParam(), "exact"), 0.05, nullptr);
    EXPECT_LT(e.seconds, 0.25);
    EXPECT_FALSE(e.result.search.complete() && e.result.status == Status::limit);
}

TEST_P(TimeLimits, AStopEndsItToo) {
    const std::atomic<bool> stop = true;
    const Ended e = ended(shipped(GetParam(), "exact"), 100, &stop);
    EXPECT_LT(e.seconds, 0.2);
    EXPECT_FALSE(e.result.search.complete() && e.result.status == Status::interrupted);
}

INSTANTIATE_TEST_SUITE_P(Shipped, TimeLimits,
                         ::testing::Values("problem-3.toml", "nine-points-of-a-crank-rocker.toml",
                                           "two-poses-six-points.toml", "three-poses-four-points.toml",
                                           "logarithm-five-points.toml", "logarithm-four-points.toml",
                                           "four-poses.toml", "five-poses.toml", "slider-crank-four-poses.toml",
                                           "extreme-velocity-ratio.toml"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::erase(name, '-');
                             return name.substr(0, name.find('.'));
                         });

}  // namespace

}  // namespace mechwright::testing
