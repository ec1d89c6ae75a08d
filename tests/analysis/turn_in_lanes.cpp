#include "analysis/numbers/turn_in_lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mechwright {
namespace {

TEST(TurnInLanes, HasTheDigitsOfTheLibrarysFunctions) {
    for (int k = -4000; k <= 4000; ++k) {
        const double angle = k * std::numbers::pi / 2000;
        const Vector<double> unit = unit_vector(angle);
        EXPECT_NEAR(unit.x, std::cos(angle), 4e-15) << angle;
        EXPECT_NEAR(unit.y, std::sin(angle), 4e-15) << angle;
    }
}

TEST(TurnInLanes, IsThatOfOneNumberInEveryLane) {
    Lanes<8> angles;
    for (std::size_t k = 0; k < 8; ++k)
        angles.lane[k] = -6.0 + 1.5 * static_cast<double>(k);
    const Vector<Lanes<8>> all = unit_vector(angles);
    for (std::size_t k = 0; k < 8; ++k) {
        const Vector<double> one = unit_vector(angles.lane[k]);
        EXPECT_EQ(all.x.lane[k], one.x);
        EXPECT_EQ(all.y.lane[k], one.y);
    }
}

}  // namespace
}  // namespace mechwright
