// Branch and bound on functions whose least value is known.

#include "synthesis/proof/branch_and_bound.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

namespace mechwright {

namespace {

using Clock = std::chrono::steady_clock;

/// 1 + (x - 0.3)^2 + (y + 0.2)^2 over a box, by its least in each variable.
BoxBound of_bowl(const Box& box) {
    const auto least = [&](std::size_t k, double at) {
        const double away = std::max(0.0, std::abs(box.middle[k] - at) - box.half[k]);
        return away * away;
    };
    return {1 + least(0, 0.3) + least(1, -0.2), box.half[0] >= box.half[1] ? 0u : 1u};
}

std::vector<Box> square() {
    Box box;
    box.half = {1, 1, 0, 0};
    return {box};
}

TEST(BranchAndBound, RaisesTheBoundToTheLeastValue) {
    const LowerBound found = lower_bound(square(), of_bowl, 1, {}, Clock::time_point::max());
    EXPECT_TRUE(found.reached);
    EXPECT_EQ(found.least, 1);
}

TEST(BranchAndBound, DoesNotReachWhatIsAboveIt) {
    const LowerBound found = lower_bound(square(), of_bowl, 1.001, {}, Clock::now() + std::chrono::milliseconds(50));
    EXPECT_FALSE(found.reached);
    EXPECT_TRUE(found.ended);
    EXPECT_NEAR(found.least, 0.9009, 1e-12);
}

TEST(BranchAndBound, StopsWhenAskedTo) {
    const std::atomic<bool> stop = true;
    RunOptions options;
    options.stop = &stop;
    EXPECT_FALSE(lower_bound(square(), of_bowl, 1.001, options, Clock::time_point::max()).reached);
}

TEST(BranchAndBound, IsTheSameForAnyNumberOfThreads) {
    const auto run = [](int jobs) {
        RunOptions options;
        options.jobs = jobs;
        const auto wavy = [](const Box& box) {
            // A bound that lags behind the function by the size of the box.
            const double x = box.middle[0], y = box.middle[1];
            return BoxBound{std::sin(9 * x) + std::cos(7 * y) + 3 - 9 * box.half[0] - 7 * box.half[1],
                            box.half[0] >= box.half[1] ? 0u : 1u};
        };
        return lower_bound(square(), wavy, 0.999, options, Clock::time_point::max());
    };
    const LowerBound one = run(1), three = run(3);
    EXPECT_TRUE(one.reached);
    EXPECT_EQ(one.boxes, three.boxes);
    EXPECT_EQ(one.least, three.least);
}

/// A box without extension cannot be divided: its bound stays.
TEST(BranchAndBound, EndsAtAPoint) {
    const LowerBound found = lower_bound({Box{}}, of_bowl, 2, {}, Clock::time_point::max());
    EXPECT_FALSE(found.reached);
    EXPECT_FALSE(found.ended);
    EXPECT_LE(found.least, 1.13);
}

}  // namespace

}  // namespace mechwright
