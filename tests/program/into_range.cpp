// Angles moved by whole turns into a range.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "synthesis/program/program.h"

namespace mechwright::testing {

namespace {

constexpr double turn = 2 * std::numbers::pi;

TEST(IntoRange, MovesByWholeTurns) {
    EXPECT_EQ(into_range(0.5, -1, 1), 0.5);
    EXPECT_NEAR(into_range(0.5, turn, 2 * turn), 0.5 + turn, 1e-15);
    EXPECT_NEAR(into_range(0.5 + 7 * turn, 0, turn), 0.5, 1e-13);
    EXPECT_NEAR(into_range(-0.5, 20 * turn, 21 * turn), 21 * turn - 0.5, 1e-13);
}

TEST(IntoRange, EndsAtARangeOfLessThanATurn) { EXPECT_EQ(into_range(3, 0, 1), 1); }

TEST(IntoRange, ReachesARangeThatSingleTurnsDoNotReach) {
    for (const double far : {1e12, 1e18, 1e100}) {
        EXPECT_EQ(into_range(0.3, far, 2 * far), std::clamp(into_range(0.3, far, 2 * far), far, 2 * far));
        EXPECT_EQ(into_range(0.3, -2 * far, -far), std::clamp(into_range(0.3, -2 * far, -far), -2 * far, -far));
    }
}

}  // namespace

}  // namespace mechwright::testing
