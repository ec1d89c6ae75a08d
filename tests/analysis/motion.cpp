// Velocities and accelerations against the derivatives of the pose in time, carried by dual numbers; and against the
// balance of power, with forces from statics alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/four_bar.h"
#include "analysis/numbers/dual.h"
#include "analysis/numbers/second_dual.h"
#include "tests/analysis/random_linkages.h"

namespace mechwright::test {
namespace {

using Time = SecondDual<double, 1>;

/// The crank angle as a function of time, at the instant where it has this speed and acceleration.
Time turning(double angle, double speed, double speeding) {
    Time theta(angle);
    theta.first[0] = speed;
    theta.second[0] = speeding;
    return theta;
}

struct Instant {
    FourBar<double> links;
    Assembly assembly;
    double angle, speed, speeding;
    CouplerPoint<double> point;

    double size() const { return links.ground + links.crank + std::hypot(point.along, point.across); }
};

Instant random_instant(Random& random) {
    return {turning_linkage(random, 0.05), random.assembly(),     random.angle(),
            random.between(-2, 2),         random.between(-3, 3), {random.between(-1, 2), random.between(-1, 2)}};
}

/// Rate of turning of a unit vector, and the rate of that.
double rate(const Vector<Time>& u) { return u.x.value * u.y.first[0] - u.y.value * u.x.first[0]; }
double rate_of_rate(const Vector<Time>& u) { return u.x.value * u.y.second[0] - u.y.value * u.x.second[0]; }

TEST(Motion, HasTheVelocitiesAndAccelerationsOfThePoseInTime) {
    Random random(11);
    for (int i = 0; i < 1000; ++i) {
        const Instant now = random_instant(random);
        const auto& m = now.links;
        const auto moving = pose(converted<Time>(m), turning(now.angle, now.speed, now.speeding), now.assembly);
        const auto p = pose(m, now.angle, now.assembly);
        const auto v = velocity(m, p, now.speed);
        const auto a = acceleration(m, p, v, now.speeding);

        // How far the lengths and the sine of the transmission angle enlarge rounding.
        const double steep = 1 / (std::abs(p.transmission_sine) * std::min({m.coupler, m.rocker, 1.0}));
        const double tolerance = 1e-14 * (1 + steep * steep * (1 + m.crank * m.crank));
        EXPECT_EQ(moving.crank.x.value, p.crank.x);
        EXPECT_NEAR(rate(moving.crank), v.crank, tolerance);
        EXPECT_NEAR(rate(moving.coupler), v.coupler, tolerance);
        EXPECT_NEAR(rate(moving.rocker), v.rocker, tolerance);
        EXPECT_NEAR(rate_of_rate(moving.crank), a.crank, tolerance);
        EXPECT_NEAR(rate_of_rate(moving.coupler), a.coupler, 10 * steep * tolerance);
        EXPECT_NEAR(rate_of_rate(moving.rocker), a.rocker, 10 * steep * tolerance);
    }
}

TEST(Motion, MovesCouplerPointsAsTheirPositionInTime) {
    Random random(12);
    for (int i = 0; i < 1000; ++i) {
        const Instant now = random_instant(random);
        const auto& m = now.links;
        const CouplerPoint<Time> point{Time(now.point.along), Time(now.point.across)};
        const FourBar<Time> links = converted<Time>(m);
        const auto at = position(links, point, pose(links, turning(now.angle, now.speed, now.speeding), now.assembly));
        const auto p = pose(m, now.angle, now.assembly);
        const auto v = velocity(m, p, now.speed);
        const auto moving = velocity(m, now.point, p, v);
        const auto turned_to = acceleration(m, now.point, p, v, acceleration(m, p, v, now.speeding));
        const double steep = 1 / (std::abs(p.transmission_sine) * std::min({m.coupler, m.rocker, 1.0}));
        const double tolerance = 1e-14 * now.size() * (1 + steep * steep * (1 + m.crank * m.crank));
        EXPECT_NEAR(moving.x, at.x.first[0], tolerance);
        EXPECT_NEAR(moving.y, at.y.first[0], tolerance);
        EXPECT_NEAR(turned_to.x, at.x.second[0], 10 * steep * tolerance);
        EXPECT_NEAR(turned_to.y, at.y.second[0], 10 * steep * tolerance);
    }
}

TEST(Motion, HasTheSlopeOfTheVelocityRatio) {
    Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const Instant now = random_instant(random);
        using Angle = Dual<double, 1>;
        const auto ratio = velocity_ratio(converted<Angle>(now.links), Angle::variable(now.angle, 0), now.assembly);
        const double slope = velocity_ratio_slope(now.links, now.angle, now.assembly);
        const double sine = pose(now.links, now.angle, now.assembly).transmission_sine;
        const double steep = 1 / (std::abs(sine) * std::min({now.links.coupler, now.links.rocker, 1.0}));
        EXPECT_EQ(ratio.value, velocity_ratio(now.links, now.angle, now.assembly));
        EXPECT_NEAR(ratio.partial[0], slope, 1e-13 * (1 + std::pow(steep, 3)));
    }
}

// A force on the coupler point and a moment on the rocker are held by a moment on the crank; statics gives that moment
// from the forces in the pins, and the power of all three is zero.
TEST(Motion, BalancesThePowerOfForcesHeldInEquilibrium) {
    Random random(14);
    for (int i = 0; i < 1000; ++i) {
        const Instant now = random_instant(random);
        const auto& m = now.links;
        const auto p = pose(m, now.angle, now.assembly);
        const auto v = velocity(m, p, now.speed);
        const Vector<double> force{random.between(-1, 1), random.between(-1, 1)};
        const double rocker_moment = random.between(-1, 1);

        // Force in the rocker pin, on the coupler: moments about the crank pin, and of the rocker about its pivot.
        const Vector<double> coupler = m.coupler * p.coupler, rocker = m.rocker * p.rocker;
        const double about_pin = -cross(turned({now.point.along, now.point.across}, p.coupler), force);
        const double about_pivot = rocker_moment;  // rocker x (-pin force) + moment = 0
        const Vector<double> pin_force = (1 / cross(coupler, rocker)) * (about_pin * rocker - about_pivot * coupler);
        ASSERT_NEAR(cross(coupler, pin_force), about_pin, 1e-12 / std::abs(p.transmission_sine));
        ASSERT_NEAR(cross(rocker, pin_force), about_pivot, 1e-12 / std::abs(p.transmission_sine));
        const double crank_moment = -cross(m.crank * p.crank, pin_force + force);

        const double given = crank_moment * v.crank + rocker_moment * v.rocker;
        const double taken = dot(force, velocity(m, now.point, p, v));
        const double steep = 1 / (std::abs(p.transmission_sine) * std::min({m.coupler, m.rocker, 1.0}));
        EXPECT_NEAR(given + taken, 0, 1e-14 * now.size() * (1 + steep * steep));
    }
}

TEST(Motion, ScalesWithTheSpeedOfTheCrank) {
    Random random(15);
    for (int i = 0; i < 100; ++i) {
        const Instant now = random_instant(random);
        const auto p = pose(now.links, now.angle, now.assembly);
        const auto unit = velocity(now.links, p), fast = velocity(now.links, p, 8.0);
        EXPECT_EQ(fast.coupler, 8 * unit.coupler);
        EXPECT_EQ(fast.rocker, 8 * unit.rocker);
        const auto unit_acceleration = acceleration(now.links, p, unit),
                   fast_acceleration = acceleration(now.links, p, fast);
        EXPECT_EQ(fast_acceleration.coupler, 64 * unit_acceleration.coupler);
        EXPECT_EQ(fast_acceleration.rocker, 64 * unit_acceleration.rocker);
    }
}

}  // namespace
}  // namespace mechwright::test
