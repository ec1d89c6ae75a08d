// The Burmester curves: every point is a dyad, points are evenly spaced, and what the curves are known to pass is on
// them.

#include "synthesis/exact/poses/burmester_curve.h"

#include <gtest/gtest.h>

#include <random>

namespace mechwright {
namespace {

using Number = std::complex<double>;
using Three = std::array<Displacement, 3>;

Three random_poses(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    Three poses;
    for (Displacement& d : poses)
        d = {{normal(random), normal(random)}, std::polar(1.0, 2 * normal(random))};
    return poses;
}

double distance(const Dyad& a, const Dyad& b) {
    return std::hypot(std::abs(a.fixed - b.fixed), std::abs(a.moving - b.moving));
}

double nearest(const std::vector<BurmesterStretch>& stretches, const Dyad& dyad) {
    double least = 1e300;
    for (const BurmesterStretch& s : stretches)
        for (const Dyad& other : s.dyads)
            least = std::min(least, distance(dyad, other));
    return least;
}

TEST(BurmesterCurves, AreDyadsAtEvenSteps) {
    std::mt19937_64 random(3);
    constexpr double step = 0.05, reach = 15;
    for (int k = 0; k < 20; ++k) {
        const Three poses = random_poses(random);
        const auto stretches = burmester_curves(poses, step, reach);
        ASSERT_FALSE(stretches.empty());
        for (const BurmesterStretch& s : stretches) {
            for (const Dyad& dyad : s.dyads) {
                const double length = std::abs(dyad.moving - dyad.fixed);
                for (const Displacement& d : poses)
                    EXPECT_NEAR(std::abs(d.shift + dyad.moving * d.turn - dyad.fixed), length, 1e-9 * (1 + length));
            }
            for (std::size_t i = 1; i < s.dyads.size(); ++i) {
                EXPECT_LT(distance(s.dyads[i - 1], s.dyads[i]), step * 1.05);
                EXPECT_GT(distance(s.dyads[i - 1], s.dyads[i]), step * 0.9);
            }
            EXPECT_TRUE(!s.closed || distance(s.dyads.front(), s.dyads.back()) < 2 * step);
        }
    }
}

/// Dyads found in another way, by conditions of their own, lie between neighbouring points.
TEST(BurmesterCurves, HaveEveryDyadOfTheFourPosesOnThem) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    constexpr double step = 0.05, reach = 15;
    int examined = 0, missed = 0;
    for (int k = 0; k < 10; ++k) {
        const Three poses = random_poses(random);
        const auto stretches = burmester_curves(poses, step, reach);
        DyadConditions conditions;
        for (Eigen::Index i = 0; i < 3; ++i)
            conditions.row(i) = condition_of(poses[static_cast<std::size_t>(i)]);
        for (int j = 0; j < 100; ++j) {
            const Number point(normal(random), normal(random)), direction = std::polar(1.0, normal(random));
            conditions.row(3) = fixed_pivot_on_line(point, direction);
            for (const ComplexDyad& found : dyads_meeting(conditions).dyads) {
                const auto dyad = real_dyad(found);
                if (!dyad || std::hypot(std::abs(dyad->fixed), std::abs(dyad->moving)) > 0.9 * reach) continue;
                ++examined;
                missed += nearest(stretches, *dyad) > step;
            }
        }
    }
    EXPECT_GT(examined, 500);
    EXPECT_EQ(missed, 0);
}

/// Four poses of a body that one dyad guides: that dyad is on the curves.
TEST(BurmesterCurves, PassTheDyadThatMadeThePoses) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 20; ++k) {
        const Dyad made{{normal(random), normal(random)}, {normal(random), normal(random)}};
        Three poses;
        for (Displacement& d : poses) {
            const Number turn = std::polar(1.0, normal(random)), link = std::polar(1.0, normal(random));
            d = {made.fixed + (made.moving - made.fixed) * link - made.moving * turn, turn};
        }
        EXPECT_LT(nearest(burmester_curves(poses, 0.05, 15), made), 0.05);
    }
}

}  // namespace
}  // namespace mechwright
