// Designs for which nothing is published: two methods that share no code must agree, and the conditions of an optimum
// are checked by hand.

#include <numbers>

#include "tests/degree.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

TEST(Agreement, DragLinkOfGivenVelocityRatio) {
    const Solved a = solved(shipped("drag-link-velocity-ratio.toml"), "slsqp");
    const Solved b = solved(shipped("drag-link-velocity-ratio.toml"), "ipopt");
    ASSERT_EQ(a.result.status, Status::solved);
    EXPECT_NEAR(a.value("velocity-ratio-max"), 2.2, 1e-11);
    EXPECT_NEAR(a.value("transmission-angle-worst"), b.value("transmission-angle-worst"), 1e-9);
    EXPECT_NEAR(a.value("transmission-angle-worst"), 34.20927035 * degree, 1e-9);
}

TEST(Agreement, BestTransmissionAloneIsTheCentricLinkageOnItsLimits) {
    const Solved a = solved(shipped("best-transmission.toml"), "slsqp");
    const Solved b = solved(shipped("best-transmission.toml"), "ipopt");
    ASSERT_EQ(a.result.status, Status::solved);
    EXPECT_NEAR(a.value("transmission-angle-worst"), b.value("transmission-angle-worst"), 1e-9);
    // The two extremes of the transmission angle are equally far from 90 deg.
    EXPECT_NEAR(a.value("transmission-angle-min") + a.value("transmission-angle-max"), std::numbers::pi, 1e-9);
    EXPECT_NEAR(a.value("swing") / degree, 50, 1e-9);
    EXPECT_NEAR(a.value("link-ratio"), 4, 1e-9);
}

TEST(Agreement, WeightedSumCountsInTheUnitsOfTheFile) {
    const Solved a = solved(shipped("crank-rocker-compact.toml"), "slsqp");
    const Solved b = solved(shipped("crank-rocker-compact.toml"), "ipopt");
    ASSERT_EQ(a.result.status, Status::solved);
    EXPECT_NEAR(a.result.best->objective, b.result.best->objective, 1e-8);
    EXPECT_NEAR(a.result.best->objective, -a.value("transmission-angle-worst") / degree + 0.1 * a.value("total-length"),
                1e-12);
    // Along the one-parameter family with the crank at its limit no neighbour is better.
    EXPECT_NEAR(a.result.best->objective, -28.4525553735, 1e-8);
}

}  // namespace

}  // namespace mechwright
