// Directions in fifty digits from a table and short series, against cosine and sine by themselves.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "synthesis/mechanism/linkage/again/loop.h"
#include "synthesis/mechanism/quantity.h"

namespace mechwright {

namespace {

TEST(LinkageDirections, AreCosineAndSineInFiftyDigits) {
    const Digits50 part = atan(Digits50(1)) / 16;
    std::mt19937_64 random(1);
    std::vector<Digits50> angles{0, 1e-30, -1e-30, 490, -490, 600, 1e6, 1e30};
    // About the edges of the parts and in their middles, in the table and beyond.
    for (int k = -300; k <= 300; ++k)
        for (const double off : {0.0, 0.5, -0.5 + 1e-15, 1e-25})
            angles.push_back((k + Digits50(off)) * part);
    for (int i = 0; i < 300; ++i)
        angles.push_back(Digits50(std::uniform_real_distribution<>(-20, 20)(random)) / 3);
    for (const Digits50& angle : angles) {
        const Vector<Digits50> direction = loop_detail::direction_of(angle);
        // To the rounding of the angle itself.
        const Digits50 rounding = 4e-50 * (1 + abs(angle));
        EXPECT_LE(abs(direction.x - cos(angle)), rounding) << angle;
        EXPECT_LE(abs(direction.y - sin(angle)), rounding) << angle;
        EXPECT_LE(abs(dot(direction, direction) - 1), Digits50(4e-50)) << angle;
    }
}

}  // namespace

}  // namespace mechwright
