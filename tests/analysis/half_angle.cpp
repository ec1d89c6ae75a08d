// Angles kept as half-angle pairs: triangles whose angles are known, and needles, where the law of cosines loses all
// digits.

#include "analysis/geometry/half_angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/analysis/precise.h"

namespace mechwright::test {
namespace {

/// The half angle between the sides a >= b of a triangle, opposite to c, in Kahan's arrangement.
HalfAngle<double> between(double a, double b, double c) {
    const double mu = b >= c ? c - (a - b) : b - (a - c);
    return {root_or_zero(((a - b) + c) * mu), root_or_zero((a + (b + c)) * ((a - c) + b))};
}

Precise exact_angle(double a, double b, double c) {
    const Precise p(a), q(b), r(c);
    return acos((p * p + q * q - r * r) / (2 * p * q));
}

TEST(HalfAngles, GiveTheAnglesOfKnownTriangles) {
    EXPECT_DOUBLE_EQ(angle(between(4, 3, 5)), std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(angle(between(1, 1, 1)), std::numbers::pi / 3);
    EXPECT_DOUBLE_EQ(angle(between(8, 5, 7)), std::numbers::pi / 3);      // 49 = 64 + 25 - 40
    EXPECT_DOUBLE_EQ(angle(between(5, 3, 7)), 2 * std::numbers::pi / 3);  // 49 = 25 + 9 + 15
    EXPECT_EQ(angle(between(3, 2, 5)), std::numbers::pi);
    EXPECT_EQ(angle(between(3, 2, 1)), 0);
}

TEST(HalfAngles, KeepAllDigitsInNeedles) {
    for (int k = 1; k <= 50; ++k) {
        const double margin = std::ldexp(1.0, -k);
        // Nearly folded: c = (a - b)(1 + margin); nearly stretched: c = (a + b)(1 - margin).
        const double folded = 0.25 * (1 + margin), stretched = 1.75 * (1 - margin);
        EXPECT_GE(digits(angle(between(1, 0.75, folded)), exact_angle(1, 0.75, folded)), 15) << k;
        const auto near_pi = between(1, 0.75, stretched);
        EXPECT_GE(digits(angle(near_pi), exact_angle(1, 0.75, stretched)), 15) << k;
        // The distance to pi keeps its own digits.
        const Precise rest = acos(Precise(-1)) - exact_angle(1, 0.75, stretched);
        EXPECT_GE(digits(angle(supplement(near_pi)), rest), 15) << k;
    }
}

TEST(HalfAngles, AddUpToPiWithTheirSupplements) {
    for (const double side : {0.3, 0.9, 1.2, 1.6})
        EXPECT_DOUBLE_EQ(angle(between(1, 0.75, side)) + angle(supplement(between(1, 0.75, side))), std::numbers::pi);
}

TEST(HalfAngles, DifferFromEachOtherByASignedAngle) {
    const auto right = between(4, 3, 5), sixty = between(1, 1, 1);
    EXPECT_DOUBLE_EQ(angle_between(right, sixty), std::numbers::pi / 6);
    EXPECT_DOUBLE_EQ(angle_between(sixty, right), -std::numbers::pi / 6);
    EXPECT_EQ(angle_between(right, right), 0);
    EXPECT_DOUBLE_EQ(angle_between(between(3, 2, 5), between(3, 2, 1)), std::numbers::pi);
}

TEST(HalfAngles, TakeTheRootOfNothingNegative) {
    EXPECT_EQ(root_or_zero(4.0), 2);
    EXPECT_EQ(root_or_zero(0.0), 0);
    EXPECT_EQ(root_or_zero(-1e-300), 0);
}

}  // namespace
}  // namespace mechwright::test
