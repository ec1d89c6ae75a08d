// Example 4-2 of Theory of Machines: crank 300, coupler 360, rocker 360, ground 600 mm; the crank turns at 10 rad/s and
// slows down by 30 rad/s^2. The table was computed anew from the loop equations in plain double arithmetic; it agrees
// with the printed one but for three errors of print. `open`: the rocker pin left of the line crank pin - rocker pivot.

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/four_bar.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {
namespace {

constexpr FourBar<double> linkage{600, 300, 360, 360};
constexpr double speed = 10, slowing = -30;
constexpr double last_digit = 5.1e-7;  // half of the sixth decimal

double direction(const Vector<double>& v) { return std::atan2(v.y, v.x) / degree; }

TEST(VelocityTableReference, MovesAsTabulatedInBothAssemblies) {
    struct Row {
        double crank_angle;
        Assembly assembly;
        double rocker_angle, coupler_angle, rocker_velocity, coupler_velocity, rocker_acceleration,
            coupler_acceleration;
    };
    constexpr auto open = Assembly::open, crossed = Assembly::crossed;
    constexpr Row table[]{
        {0, crossed, -114.624318, -65.375682, -10.000000, -10.000000, -61.669850, 121.669850},
        {0, open, 114.624318, 65.375682, -10.000000, -10.000000, 121.669850, -61.669850},
        {30, crossed, -144.883764, -82.704189, -8.692283, -0.840259, 101.517085, 181.427345},
        {30, open, 97.295811, 35.116236, -0.840259, -8.692283, 181.427345, 101.517085},
        {60, crossed, -166.194008, -73.805992, -6.019293, 6.019293, 38.018555, 77.451499},
        {60, open, 106.194008, 13.805992, 6.019293, -6.019293, 77.451499, 38.018555},
        {90, crossed, 174.734355, -47.864458, -8.259784, 12.259784, -180.175819, 216.175819},
        {90, open, 132.135542, -5.265645, 12.259784, -8.259784, 216.175819, -180.175819},
        {270, crossed, -132.135542, 5.265645, 12.259784, -8.259784, -289.734520, 229.734520},
        {270, open, -174.734355, 47.864458, -8.259784, 12.259784, 229.734520, -289.734520},
        {300, crossed, -106.194008, -13.805992, 6.019293, -6.019293, -113.567255, -1.902799},
        {300, open, 166.194008, 73.805992, -6.019293, 6.019293, -1.902799, -113.567255},
        {330, crossed, -97.295811, -35.116236, -0.840259, -8.692283, -176.385788, -49.363389},
        {330, open, 144.883764, 82.704189, -8.692283, -0.840259, -49.363389, -176.385788},
    };
    for (const Row& row : table) {
        const auto p = pose(linkage, row.crank_angle * degree, row.assembly);
        ASSERT_TRUE(p.assembled());
        const auto v = velocity(linkage, p, speed);
        const auto a = acceleration(linkage, p, v, slowing);
        EXPECT_NEAR(direction(p.rocker), row.rocker_angle, last_digit) << row.crank_angle;
        EXPECT_NEAR(direction(p.coupler), row.coupler_angle, last_digit) << row.crank_angle;
        EXPECT_NEAR(v.rocker, row.rocker_velocity, last_digit) << row.crank_angle;
        EXPECT_NEAR(v.coupler, row.coupler_velocity, last_digit) << row.crank_angle;
        EXPECT_NEAR(a.rocker, row.rocker_acceleration, last_digit) << row.crank_angle;
        EXPECT_NEAR(a.coupler, row.coupler_acceleration, last_digit) << row.crank_angle;
        EXPECT_EQ(v.crank, speed);
        EXPECT_EQ(a.crank, slowing);
        EXPECT_NEAR(velocity_ratio(linkage, row.crank_angle * degree, row.assembly), row.rocker_velocity / speed,
                    last_digit / speed);
    }
}

TEST(VelocityTableReference, HasItsTransmissionAngles) {
    struct Row {
        double crank_angle, transmission_angle;
    };
    constexpr Row table[]{{0, 49.24864},   {30, 62.17957},  {330, 62.17957}, {60, 92.38802},
                          {300, 92.38802}, {90, 137.40119}, {270, 137.40119}};
    for (const Row& row : table)
        EXPECT_NEAR(transmission_angle(linkage, half_turn(row.crank_angle * degree)) / degree, row.transmission_angle,
                    5.1e-6);
}

TEST(VelocityTableReference, AssemblesOnlyNearTheGroundLink) {
    EXPECT_EQ(classify(linkage).kind, FourBarClass::triple_rocker);
    const auto range = assembled_range(linkage);
    EXPECT_FALSE(range.full_turn || range.mirrored);
    EXPECT_NEAR(range.to / degree, 100.952784, last_digit);
    EXPECT_EQ(range.from, -range.to);
    for (const double crank_angle : {120.0, 150.0, 180.0, 210.0, 240.0})
        EXPECT_FALSE(pose(linkage, crank_angle * degree, Assembly::open).assembled());
    EXPECT_TRUE(pose(linkage, range.to * (1 - 1e-15), Assembly::open).margins.stretch >= 0);
    EXPECT_FALSE(pose(linkage, range.to * (1 + 1e-15), Assembly::open).assembled());
}

// A point of the coupler at 180 mm from the crank pin, turned 30 deg to the left of the coupler.
TEST(VelocityTableReference, MovesItsCouplerPoint) {
    const CouplerPoint<double> point{180 * std::cos(30 * degree), 180 * std::sin(30 * degree)};
    struct Row {
        double crank_angle;
        Assembly assembly;
        Vector<double> position, velocity, acceleration;
    };
    const Row table[]{
        {30, Assembly::open, {335.547800, 313.289391}, {-80.642448, 1939.721164}, {-43780.033, -27442.764}},
        {60, Assembly::crossed, {279.903811, 135.208263}, {-1848.076211, 2281.929053}, {-2262.024, -15905.048}}};
    for (const Row& row : table) {
        const auto p = pose(linkage, row.crank_angle * degree, row.assembly);
        const auto v = velocity(linkage, p, speed);
        const auto a = acceleration(linkage, p, v, slowing);
        const auto at = position(linkage, point, p);
        const auto moving = velocity(linkage, point, p, v);
        const auto turning = acceleration(linkage, point, p, v, a);
        EXPECT_NEAR(at.x, row.position.x, last_digit);
        EXPECT_NEAR(at.y, row.position.y, last_digit);
        EXPECT_NEAR(moving.x, row.velocity.x, last_digit);
        EXPECT_NEAR(moving.y, row.velocity.y, last_digit);
        EXPECT_NEAR(turning.x, row.acceleration.x, 5.1e-4);
        EXPECT_NEAR(turning.y, row.acceleration.y, 5.1e-4);
    }
}

}  // namespace
}  // namespace mechwright::test
