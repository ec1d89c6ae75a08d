// Exercise 2-3 of Theory of Machines: ground 100, crank 25, coupler 90, rocker 75 mm, the rocker pin above the ground
// line. The exercise asks for the transmission angle, the limit positions and the path of the middle of the coupler;
// the numbers were computed once in plain double arithmetic, by the law of cosines, and are given to their last digit.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/four_bar.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {
namespace {

constexpr FourBar<double> linkage{100, 25, 90, 75};
constexpr CouplerPoint<double> middle{45, 0};
constexpr double last_digit = 5.1e-7;  // half of the sixth decimal

double direction(const Vector<double>& v) { return std::atan2(v.y, v.x) / degree; }

TEST(CrankRockerReference, IsACrankRockerWithItsMargins) {
    const Grashof grashof = classify(linkage);
    EXPECT_EQ(grashof.kind, FourBarClass::crank_rocker);
    EXPECT_FALSE(grashof.change_point || grashof.parallelogram || grashof.kite);
    EXPECT_EQ(grashof_margin(linkage), 40);  // 90 + 75 - 25 - 100
    EXPECT_EQ(closing_margin(linkage), 90);  // 25 + 75 + 90 - 100
    const auto margins = crank_rocker_margins(linkage);
    EXPECT_EQ(margins.ground_longest, 40);
    EXPECT_EQ(margins.coupler_longest, 60);
    EXPECT_EQ(margins.rocker_longest, 90);
    EXPECT_TRUE(assembled_range(linkage).full_turn);
}

TEST(CrankRockerReference, MovesAsTabulated) {
    struct Row {
        double crank_angle, x, y, rocker_angle;
    };
    constexpr Row table[]{
        {0, 52.000000, 36.000000, 106.260205},   {30, 54.534769, 43.218622, 99.656906},
        {60, 49.221555, 47.660775, 100.802560},  {90, 38.552502, 48.210010, 107.774204},
        {120, 26.490376, 44.117289, 117.403669}, {150, 16.604373, 36.197139, 127.004298},
        {180, 11.200000, 26.731255, 134.534076}, {210, 10.985966, 18.481483, 138.737775},
        {240, 15.366767, 13.682682, 139.190458}, {270, 23.094556, 13.621775, 135.846691},
        {300, 32.855368, 18.482381, 128.598332}, {330, 43.343772, 26.925979, 117.786263},
    };
    for (const Row& row : table) {
        const auto p = pose(linkage, row.crank_angle * degree, Assembly::open);
        EXPECT_TRUE(p.assembled());
        const auto c = position(linkage, middle, p);
        EXPECT_NEAR(c.x, row.x, last_digit) << row.crank_angle;
        EXPECT_NEAR(c.y, row.y, last_digit) << row.crank_angle;
        EXPECT_NEAR(direction(p.rocker), row.rocker_angle, last_digit) << row.crank_angle;
    }
}

TEST(CrankRockerReference, HasItsTransmissionAngles) {
    struct Row {
        double crank_angle, transmission_angle;
    };
    constexpr Row table[]{{0, 53.1301},   {30, 56.6069},  {60, 65.4923}, {90, 76.7247},
                          {120, 87.4527}, {150, 95.2281}, {180, 98.0907}};
    for (const Row& row : table) {
        const double theta = row.crank_angle * degree;
        EXPECT_NEAR(transmission_angle(linkage, half_turn(theta)) / degree, row.transmission_angle, 5.1e-5);
        // The same from the pose, and the same below the ground line.
        const auto p = pose(linkage, theta, Assembly::crossed);
        EXPECT_NEAR(std::atan2(-p.transmission_sine, p.transmission_cosine) / degree, row.transmission_angle, 5.1e-5);
        EXPECT_NEAR(transmission_angle(linkage, half_turn(-theta)) / degree, row.transmission_angle, 5.1e-5);
    }
    const auto extremes = transmission_extremes_of_full_turn();
    ASSERT_EQ(extremes.count, 2u);
    EXPECT_NEAR(transmission_angle(linkage, extremes.at[0]) / degree, 53.130102, last_digit);
    EXPECT_NEAR(transmission_angle(linkage, extremes.at[1]) / degree, 98.090712, last_digit);
}

TEST(CrankRockerReference, HasItsLimitPositions) {
    const auto limits = limit_positions(linkage, Assembly::open);
    EXPECT_NEAR(limits.extended.crank_angle / degree, 40.073664, last_digit);
    EXPECT_NEAR(limits.extended.rocker_angle / degree, 99.206896, last_digit);
    EXPECT_NEAR(limits.extended.transmission_angle / degree, 59.133232, last_digit);
    EXPECT_NEAR(limits.folded.crank_angle / degree, 228.582690, last_digit);
    EXPECT_NEAR(limits.folded.rocker_angle / degree, 139.464198, last_digit);
    EXPECT_NEAR(limits.folded.transmission_angle / degree, 90.881508, last_digit);
}

TEST(CrankRockerReference, ReachesItsLimitsWithCrankAndCouplerInLine) {
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
        const auto limits = limit_positions(linkage, assembly);
        for (const auto& limit : {limits.extended, limits.folded}) {
            const auto p = pose(linkage, limit.crank_angle, assembly);
            EXPECT_NEAR(cross(p.crank, p.coupler), 0, 1e-15);
            EXPECT_NEAR(velocity(linkage, p).rocker, 0, 1e-15);
            EXPECT_NEAR(direction(p.rocker), limit.rocker_angle / degree, 1e-12);
            EXPECT_NEAR(transmission_angle(linkage, half_turn(limit.crank_angle)), limit.transmission_angle, 1e-14);
        }
    }
}

TEST(CrankRockerReference, SwingsAndTakesItsTime) {
    EXPECT_NEAR(swing(linkage) / degree, 40.257302, last_digit);
    const double excess = stroke_excess(linkage);
    EXPECT_NEAR(180 + excess / degree, 188.509026, last_digit);
    EXPECT_NEAR(180 - excess / degree, 171.490974, last_digit);
    EXPECT_NEAR((std::numbers::pi + excess) / (std::numbers::pi - excess), 1.099236, last_digit);
    const auto limits = limit_positions(linkage, Assembly::open);
    EXPECT_DOUBLE_EQ(swing(linkage), limits.folded.rocker_angle - limits.extended.rocker_angle);
    EXPECT_NEAR(std::numbers::pi + excess, limits.folded.crank_angle - limits.extended.crank_angle, 1e-15);
}

}  // namespace
}  // namespace mechwright::test
