// Poses at the places where formulas break: toggles, change points, positions that do not assemble, pins together.

#include "analysis/four_bar/pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/four_bar.h"
#include "tests/analysis/precise.h"
#include "tests/analysis/random_linkages.h"

namespace mechwright::test {
namespace {

constexpr HalfTurn<double> at_zero{1, 0}, at_pi{0, 1};

/// To four units of the last place; one of them is that of the diagonal, the plain root of a sum of two squares.
void expect_direction(const Vector<double>& v, double x, double y) {
    EXPECT_NEAR(v.x, x, 9e-16);
    EXPECT_NEAR(v.y, y, 9e-16);
}

double after(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double before(double x) { return std::nextafter(x, 0); }

TEST(Pose, IsExactForTheCrankOnTheGroundLine) {
    const FourBar<double> m{6, 2, 3, 5};  // diagonals 4 and 8: a right triangle, and the stretched toggle
    const auto zero = pose(m, at_zero, Assembly::open);
    expect_direction(zero.crank, 1, 0);
    expect_direction(zero.coupler, 0, 1);
    expect_direction(zero.rocker, -0.8, 0.6);
    EXPECT_NEAR(zero.transmission_sine, 0.8, 1e-16);
    EXPECT_NEAR(zero.transmission_cosine, 0.6, 1e-16);
    EXPECT_EQ(zero.margins.diagonal, 4);
    EXPECT_EQ(zero.margins.stretch, 4);
    EXPECT_EQ(zero.margins.fold, 2);

    const auto pi = pose(m, at_pi, Assembly::open);
    expect_direction(pi.crank, -1, 0);
    expect_direction(pi.coupler, 1, 0);
    expect_direction(pi.rocker, -1, 0);
    EXPECT_EQ(pi.margins.stretch, 0);
    EXPECT_TRUE(pi.assembled());
    EXPECT_EQ(pi.transmission_sine, 0);
    EXPECT_EQ(pi.transmission_cosine, -1);
}

TEST(Pose, ThatDoesNotAssembleIsThatOfTheNearestToggle) {
    const FourBar<double> too_far{9, 2, 3, 5};  // 11 at pi
    const auto stretched = pose(too_far, at_pi, Assembly::open);
    EXPECT_FALSE(stretched.assembled());
    EXPECT_EQ(stretched.margins.stretch, -3);
    expect_direction(stretched.coupler, 1, 0);
    expect_direction(stretched.rocker, -1, 0);
    EXPECT_EQ(stretched.transmission_sine, 0);
    EXPECT_EQ(stretched.transmission_cosine, -1);

    for (const bool coupler_longer : {true, false}) {
        const FourBar<double> too_near{3, 2, coupler_longer ? 6.0 : 3.0, coupler_longer ? 3.0 : 6.0};  // 1 at zero
        const auto folded = pose(too_near, at_zero, Assembly::crossed);
        EXPECT_FALSE(folded.assembled());
        EXPECT_EQ(folded.margins.fold, -2);
        const double toward = coupler_longer ? 1 : -1;
        expect_direction(folded.coupler, toward, 0);
        expect_direction(folded.rocker, toward, 0);
        EXPECT_EQ(folded.transmission_sine, 0);
        EXPECT_EQ(folded.transmission_cosine, 1);
    }
}

TEST(Pose, ChangesLittleAcrossAToggle) {
    const FourBar<double> m{600, 300, 360, 360};
    const double toggle = assembled_range(m).to;
    const auto inside = pose(m, toggle - 1e-12, Assembly::open), outside = pose(m, toggle + 1e-12, Assembly::open);
    EXPECT_TRUE(inside.assembled());
    EXPECT_FALSE(outside.assembled());
    EXPECT_NEAR(cross(inside.coupler, outside.coupler), 0, 1e-5);
    EXPECT_NEAR(dot(inside.rocker, outside.rocker), 1, 1e-10);
}

TEST(Pose, OfAKiteWithItsPinsTogetherLiesInOneLine) {
    const FourBar<double> kite{4, 4, 3, 3};  // the crank pin falls on the rocker pivot
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
        const auto p = pose(kite, at_zero, assembly);
        EXPECT_TRUE(p.assembled());
        EXPECT_EQ(p.margins.fold, 0);
        EXPECT_EQ(p.margins.diagonal, 0);
        expect_direction(p.coupler, side_of(assembly), 0);
        expect_direction(p.rocker, side_of(assembly), 0);
        EXPECT_EQ(p.transmission_sine, 0);
        EXPECT_EQ(p.transmission_cosine, 1);
        // It is the limit of the poses as the crank turns on.
        const auto next = pose(kite, 1e-12, assembly);
        EXPECT_NEAR(std::hypot(next.coupler.x - p.coupler.x, next.coupler.y - p.coupler.y), 0, 2e-12);
        EXPECT_NEAR(std::hypot(next.rocker.x - p.rocker.x, next.rocker.y - p.rocker.y), 0, 2e-12);
    }
    const auto unequal = pose(FourBar<double>{4, 4, 3, 2}, at_zero, Assembly::open);
    EXPECT_FALSE(unequal.assembled());
    EXPECT_EQ(unequal.margins.fold, -1);
    EXPECT_EQ(dot(unequal.coupler, unequal.coupler), 1);
    EXPECT_EQ(dot(unequal.rocker, unequal.rocker), 1);
}

TEST(Pose, OfAParallelogramKeepsItsSidesParallel) {
    const FourBar<double> m{4, 2, 4, 2};
    for (double theta = 0.25; theta < std::numbers::pi; theta += 0.25) {
        const auto p = pose(m, theta, Assembly::open);
        expect_direction(p.coupler, 1, 0);
        expect_direction(p.rocker, p.crank.x, p.crank.y);
        const auto v = velocity(m, p);
        EXPECT_NEAR(v.rocker, 1, 2e-15);
        EXPECT_NEAR(v.coupler, 0, 2e-15);
    }
    for (double theta = 1e-12; theta < 0.1; theta *= 10) {  // close to the change point
        EXPECT_NEAR(velocity_ratio(m, theta, Assembly::open), 1, 4e-15) << theta;
        EXPECT_NEAR(velocity_ratio(m, std::numbers::pi - theta, Assembly::open), 1, 4e-15) << theta;
    }
}

// The sign of a margin at the two ends of the ground line is that of the exact sum of four lengths.
TEST(Pose, SeesOneUnitInTheLastPlace) {
    Random random(21);
    for (int i = 0; i < 2000; ++i) {
        FourBar<double> m{random.between(0.1, 2), random.between(0.1, 2), random.between(0.1, 2), 0};
        const bool zero = random.coin(), stretch = random.coin();
        const Precise d = zero ? abs(Precise(m.ground) - m.crank) : Precise(m.ground) + m.crank;
        const Precise edge = stretch ? d - m.coupler : m.coupler + d * (random.coin() ? 1 : -1);
        if (edge <= Precise(1e-3)) continue;
        m.rocker = static_cast<double>(edge);
        for (const double rocker : {before(m.rocker), m.rocker, after(m.rocker)}) {
            m.rocker = rocker;
            const Precise exact = stretch ? Precise(m.coupler) + m.rocker - d : d - abs(Precise(m.coupler) - m.rocker);
            const auto margins = assembly_margins(m, zero ? at_zero : at_pi);
            EXPECT_EQ(stretch ? margins.stretch : margins.fold, static_cast<double>(exact));
            EXPECT_EQ(pose(m, zero ? at_zero : at_pi, Assembly::open).assembled(), exact >= 0 && margins.closed());
        }
    }
}

TEST(TransmissionExtremes, OfALimitedRangeAreItsEndsAndTheGroundLine) {
    const auto count = [](double from, double to) { return transmission_extremes(from, to).count; };
    EXPECT_EQ(count(0.5, 1.0), 2u);
    EXPECT_EQ(count(-0.5, 1.0), 3u);
    EXPECT_EQ(count(0.5, 4.0), 3u);
    EXPECT_EQ(count(-0.5, 4.0), 4u);
    EXPECT_EQ(count(100.0, 101.0), 3u);  // 32 pi = 100.53
    EXPECT_EQ(count(-4.0, -3.0), 3u);
    EXPECT_EQ(count(0.0, 1.0), 2u);
    const auto all = transmission_extremes(-0.5, 4.0);
    EXPECT_EQ(all.at[0].cosine, std::cos(-0.25));
    EXPECT_EQ(all.at[1].sine, std::sin(2.0));
    EXPECT_EQ(all.at[2].cosine, 1);
    EXPECT_EQ(all.at[3].sine, 1);
}

TEST(TransmissionExtremes, AreThoseOfAScan) {
    Random random(22);
    for (int i = 0; i < 200; ++i) {
        const auto m = turning_linkage(random, 0.01);
        const double from = random.between(-7, 7), to = from + random.between(0.1, 6);
        double least = 4, greatest = -1, listed_least = 4, listed_greatest = -1;
        const auto extremes = transmission_extremes(from, to);
        for (std::size_t k = 0; k < extremes.count; ++k) {
            listed_least = std::min(listed_least, transmission_angle(m, extremes.at[k]));
            listed_greatest = std::max(listed_greatest, transmission_angle(m, extremes.at[k]));
        }
        constexpr int steps = 400;
        for (int k = 0; k <= steps; ++k) {
            const double mu = transmission_angle(m, half_turn(from + (to - from) * k / steps));
            least = std::min(least, mu);
            greatest = std::max(greatest, mu);
        }
        EXPECT_LE(listed_least, least + 1e-15);
        EXPECT_GE(listed_greatest, greatest - 1e-15);
        EXPECT_NEAR(listed_least, least, 0.05);
        EXPECT_NEAR(listed_greatest, greatest, 0.05);
    }
}

}  // namespace
}  // namespace mechwright::test
