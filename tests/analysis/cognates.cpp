// The Roberts-Chebyshev cognates: lengths by complex numbers, a published pair, and coinciding curves.

#include "analysis/four_bar/cognates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "tests/analysis/precise.h"
#include "tests/analysis/random_linkages.h"

namespace mechwright::test {
namespace {

Vector<double> drawn(const PathLinkage<double>& l, double crank_angle) {
    return placed(position(l.links, l.point, pose(l.links, crank_angle, l.assembly)), l.placement);
}

double direction(const Vector<double>& v) { return std::atan2(v.y, v.x); }

PathLinkage<double> random_original(Random& random) {
    return {turning_linkage(random, 0.05),
            {random.between(-1, 2), random.between(-1, 2)},
            {{random.between(-3, 3), random.between(-3, 3)}, random.angle()},
            random.assembly()};
}

// The best known answer to the closed curve of 18 points and the same minimum found in another assembly.
TEST(Cognates, OfThePublishedClosedCurveAreThePublishedPair) {
    const PathLinkage<double> original{{1.05394344, 0.42387499, 0.91424983, 0.59891689},
                                       {0.37059736, 0.39934666},
                                       {{0.2676555, 0.15464956}, 0.28482455},
                                       Assembly::open};
    const PathLinkage<double> second = cognates(original)[1];
    constexpr double eight_digits = 2e-8;
    EXPECT_NEAR(second.links.ground, 0.77763389, eight_digits);
    EXPECT_NEAR(second.links.crank, 0.31274882, eight_digits);
    EXPECT_NEAR(second.links.coupler, 0.44190044, eight_digits);
    EXPECT_NEAR(second.links.rocker, 0.67456339, eight_digits);
    EXPECT_NEAR(second.point.along, -0.04078607, eight_digits);
    EXPECT_NEAR(second.point.across, -0.35456335, eight_digits);
    EXPECT_NEAR(second.placement.origin.x, 0.54830862, eight_digits);
    EXPECT_NEAR(second.placement.origin.y, 0.7165121, eight_digits);
    EXPECT_NEAR(std::remainder(second.placement.tilt - 5.93446225, 2 * std::numbers::pi), 0, eight_digits);
    EXPECT_EQ(second.assembly, Assembly::crossed);
}

// With k the coupler point over the coupler as a complex number: third pivot A0 + k (B0 - A0); (crank, coupler, rocker)
// = |k| (coupler, crank, rocker) with coupler constant 1/k on A0, |1 - k| (crank, rocker, coupler) with k/(k - 1) on
// C0.
TEST(Cognates, HaveTheLengthsOfRobertsTheorem) {
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        const auto original = random_original(random);
        const FourBar<double>& m = original.links;
        const std::complex<double> k = std::complex(original.point.along, original.point.across) / m.coupler;
        const auto [first, second] = cognates(original);
        const double size = std::abs(k), rest = std::abs(1.0 - k);
        EXPECT_DOUBLE_EQ(first.links.ground, size * m.ground);
        EXPECT_DOUBLE_EQ(first.links.crank, size * m.coupler);
        EXPECT_DOUBLE_EQ(first.links.coupler, size * m.crank);
        EXPECT_DOUBLE_EQ(first.links.rocker, size * m.rocker);
        EXPECT_DOUBLE_EQ(second.links.ground, rest * m.ground);
        EXPECT_DOUBLE_EQ(second.links.crank, rest * m.crank);
        EXPECT_DOUBLE_EQ(second.links.coupler, rest * m.rocker);
        EXPECT_DOUBLE_EQ(second.links.rocker, rest * m.coupler);
        const auto constant = [](const PathLinkage<double>& l) {
            return std::complex(l.point.along, l.point.across) / l.links.coupler;
        };
        EXPECT_NEAR(std::abs(constant(first) * k - 1.0), 0, 1e-14);
        EXPECT_NEAR(std::abs(constant(second) * (k - 1.0) - k), 0, 1e-14 * (1 + size));

        // All three hang on the same three pivots.
        const auto end = [](const PathLinkage<double>& l) { return placed({l.links.ground, 0}, l.placement); };
        const auto a = original.placement.origin, b = end(original), c = end(first);
        EXPECT_NEAR(std::hypot(c.x - second.placement.origin.x, c.y - second.placement.origin.y), 0, 1e-13);
        EXPECT_NEAR(std::hypot(end(second).x - b.x, end(second).y - b.y), 0, 1e-13);
        EXPECT_EQ(first.placement.origin.x, a.x);
        EXPECT_EQ(first.placement.origin.y, a.y);
    }
}

TEST(Cognates, DrawTheSameCurve) {
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        const auto original = random_original(random);
        const auto [first, second] = cognates(original);
        const double size =
            original.links.ground + original.links.crank + std::hypot(original.point.along, original.point.across);
        const double spread = std::hypot(original.point.along, original.point.across) / original.links.coupler;
        for (int step = 0; step < 24; ++step) {
            const double theta = random.angle();
            const auto p = pose(original.links, theta, original.assembly);
            const auto target = drawn(original, theta);
            const double tolerance = 4e-15 * size * (1 + spread) / std::abs(p.transmission_sine);

            const auto twin = drawn(second, theta);
            EXPECT_NEAR(std::hypot(twin.x - target.x, twin.y - target.y), 0, tolerance);

            // The crank of the first turns as the coupler does, from the same ground direction plus the angle of k; its
            // assembly changes where the coupler of the original swings back.
            const double crank_angle = direction(p.coupler);
            double nearest = 1e300;
            for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
                auto both = first;
                both.assembly = assembly;
                const auto at = drawn(both, crank_angle);
                nearest = std::min(nearest, std::hypot(at.x - target.x, at.y - target.y));
            }
            const double toggle = pose(first.links, crank_angle, first.assembly).transmission_sine;
            EXPECT_NEAR(nearest, 0, tolerance / std::max(std::abs(toggle), 1e-8));
        }
    }
}

TEST(Cognates, OfACognateLeadBack) {
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const auto original = random_original(random);
        // The second keeps the crank angles, and so does the second of the second; it is turned about twice.
        const auto back = cognates(cognates(original)[1])[1];
        EXPECT_NEAR(back.links.crank, original.links.crank, 1e-13 * original.links.crank);
        EXPECT_NEAR(back.links.coupler, original.links.coupler, 1e-13 * original.links.coupler);
        EXPECT_NEAR(back.links.rocker, original.links.rocker, 1e-13 * original.links.rocker);
        EXPECT_NEAR(back.point.along, original.point.along, 1e-12);
        EXPECT_NEAR(back.point.across, original.point.across, 1e-12);
        EXPECT_EQ(back.assembly, original.assembly);
        EXPECT_NEAR(std::remainder(back.placement.tilt - original.placement.tilt, 2 * std::numbers::pi), 0, 1e-13);
    }
}

}  // namespace
}  // namespace mechwright::test
