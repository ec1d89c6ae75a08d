// Answers for which nothing is published, found by searches of our own: two methods or several seeds share them.

#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

/// Two methods that share no code, on problems for which nothing is published.
void expect_agreement(const std::string& file, double objective, double within) {
    const Solved a = solved(shipped(file, "quick-return"), "slsqp");
    const Solved b = solved(shipped(file, "quick-return"), "ipopt");
    ASSERT_EQ(a.result.status, Status::solved) << file;
    ASSERT_EQ(b.result.status, Status::solved) << file;
    EXPECT_NEAR(a.result.best->objective, b.result.best->objective, within) << file;
    EXPECT_NEAR(a.result.best->objective, objective, 10 * within) << file;
}

TEST(Pinned, QuickReturnsBySlsqpAndByIpoptAgree) {
    expect_agreement("drag-link-compact.toml", 490.1735806, 1e-7);
    expect_agreement("slider-crank-least-acceleration.toml", 56.432710, 1e-7);
    expect_agreement("slider-crank-compact.toml", 186.033171, 1e-7);
}

TEST(Pinned, PosesBySlsqpAloneAgree) {
    const double here = solved(shipped("tipper.toml", "poses")).result.best->objective;
    EXPECT_NEAR(here, 4.22911991694, 1e-8);
    EXPECT_NEAR(solved(shipped("tipper.toml", "poses"), "slsqp").result.best->objective / here, 1, 1e-8);
}

/// That it is a minimax is proven by its six alternating extremes (functions.cpp).
TEST(Pinned, FunctionOfARamIsFoundFromEverySeed) {
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(cases_to_try(2, 3)); ++seed) {
        const Solved s = solved(shipped("ram-square.toml", "function"), "auto", seed);
        EXPECT_NEAR(s.result.best->objective, 0.0087891066, 1e-9) << seed;
    }
}

}  // namespace

}  // namespace mechwright
