// Derivatives of the coupler point by the implicit function theorem against dual numbers through the closed form: two
// ways that share nothing but the pose.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/four_bar.h"
#include "analysis/numbers/dual.h"
#include "tests/analysis/random_linkages.h"

namespace mechwright::test {
namespace {

TEST(CouplerGradient, IsThatOfDualNumbers) {
    Random random(4);
    for (int k = 0; k < 20000; ++k) {
        const FourBar<double> m = turning_linkage(random, 1e-4);
        const CouplerPoint<double> point{random.between(-1, 1), random.between(-1, 1)};
        const double angle = random.angle();
        const Assembly assembly = random.assembly();
        const auto p = pose(m, angle, assembly);
        const auto gradient = position_gradient(m, point, p);

        using D = Dual<double, 7>;
        const FourBar<D> links{D::variable(m.ground, 0), D::variable(m.crank, 1), D::variable(m.coupler, 2),
                               D::variable(m.rocker, 3)};
        const CouplerPoint<D> at{D::variable(point.along, 4), D::variable(point.across, 5)};
        const Vector<D> dual = position(links, at, pose(links, D::variable(angle, 6), assembly));
        double size = 1;
        for (std::size_t i = 0; i < 7; ++i)
            size = std::max({size, std::abs(dual.x.partial[i]), std::abs(dual.y.partial[i])});
        // Near a toggle both lose what the transmission angle's sine has lost: one part in it.
        const double allowed = 1e-13 * size / std::abs(p.transmission_sine);
        for (std::size_t i = 0; i < 7; ++i) {
            EXPECT_NEAR(gradient[i].x, dual.x.partial[i], allowed) << "by argument " << i << ", linkage " << k;
            EXPECT_NEAR(gradient[i].y, dual.y.partial[i], allowed) << "by argument " << i << ", linkage " << k;
        }
    }
}

}  // namespace
}  // namespace mechwright::test
