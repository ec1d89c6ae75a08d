// The classical straight-line linkages: Roberts (exercise 2-7 of Theory of Machines), Chebyshev, Watt, and the lambda
// linkages of Chebyshev's condition. All numbers were computed once from circle intersections in plain double
// arithmetic; the 0.24 % of Chebyshev's linkage is also a printed value.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/four_bar.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {
namespace {

constexpr double last_digit = 5.1e-7;  // half of the sixth decimal

struct Drawn {
    FourBar<double> links;
    CouplerPoint<double> point;
    Assembly assembly;

    Vector<double> at(double degrees) const { return position(links, point, pose(links, degrees * degree, assembly)); }
    /// What half of the sixth decimal of a degree makes of a position, and half of the sixth decimal of the position.
    double last_digit_at(double degrees) const {
        return (1 + std::hypot(speed_at(degrees).x, speed_at(degrees).y) * degree) * last_digit;
    }
    Vector<double> speed_at(double degrees) const {
        const auto p = pose(links, degrees * degree, assembly);
        return velocity(links, point, p, velocity(links, p));
    }
};

// Crank, rocker and both sides of the coupler triangle 60, its base 50, ground 100; the point hangs below the coupler.
const Drawn roberts{{100, 60, 50, 60}, {25, -std::sqrt(60.0 * 60 - 25 * 25)}, Assembly::open};

TEST(RobertsLinkage, PassesThroughBothPivotsAndTheMiddle) {
    EXPECT_EQ(classify(roberts.links).kind, FourBarClass::triple_rocker);
    struct Row {
        double crank_angle, x;
    };
    for (const Row& row : {Row{65.375682, 50}, Row{82.805946, 0}, Row{33.557310, 100}}) {
        EXPECT_NEAR(roberts.at(row.crank_angle).x, row.x, roberts.last_digit_at(row.crank_angle));
        EXPECT_NEAR(roberts.at(row.crank_angle).y, 0, roberts.last_digit_at(row.crank_angle));
    }
}

TEST(RobertsLinkage, LeavesTheLineByAtMost0682Percent) {
    struct Row {
        double crank_angle, x;
    };
    for (const Row& row : {Row{80.643280, 13.486936}, Row{43.414092, 86.513064}}) {
        EXPECT_NEAR(roberts.at(row.crank_angle).x, row.x, 5e-6);  // the place of a flat extreme is known less well
        EXPECT_NEAR(roberts.at(row.crank_angle).y, -0.682101, last_digit);
        EXPECT_NEAR(roberts.speed_at(row.crank_angle).y, 0, 1e-5);
    }
    for (double crank_angle = 33.56; crank_angle < 82.8; crank_angle += 0.01) {
        EXPECT_LE(roberts.at(crank_angle).y, 1e-6);
        EXPECT_GE(roberts.at(crank_angle).y, -0.682101 - last_digit);
    }
}

TEST(RobertsLinkage, ReachesItsToggleAndItsWholeCurve) {
    const auto range = assembled_range(roberts.links);
    EXPECT_NEAR(range.to / degree, 82.819244, last_digit);
    // At the toggle plain double arithmetic keeps six digits; these come from forty.
    const auto end = pose(roberts.links, range.to, roberts.assembly);
    EXPECT_NEAR(position(roberts.links, roberts.point, end).x, -0.99496072885370621, 1e-6);
    EXPECT_NEAR(position(roberts.links, roberts.point, end).y, 0.13381844902871829, 1e-6);
    double left = 50, right = 50, low = 0, high = 0;
    constexpr int steps = 40000;
    for (int i = 0; i <= steps; ++i)
        for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
            // Steps that shrink towards the toggles, where the curve is fast.
            const double theta = range.to * std::sin((i - 0.5 * steps) * std::numbers::pi / steps);
            const auto p = position(roberts.links, roberts.point, pose(roberts.links, theta, assembly));
            left = std::min(left, p.x);
            right = std::max(right, p.x);
            low = std::min(low, p.y);
            high = std::max(high, p.y);
        }
    EXPECT_NEAR(left, -19.236752, 2e-6);
    EXPECT_NEAR(right, 119.236752, 2e-6);
    EXPECT_NEAR(low, -109.087121, 2e-6);
    EXPECT_NEAR(high, 19.579386, 2e-6);
}

// Ground 4, levers 5, coupler 2, drawn by the middle of the coupler.
const Drawn chebyshev{{4, 5, 2, 5}, {1, 0}, Assembly::crossed};

TEST(ChebyshevLinkage, RunsFromPivotToPivotAtTheHeightOfTheGround) {
    const double end = std::acos(0.8) / degree;  // the rocker is upright there
    for (const double crank_angle : {90.0, end}) {
        EXPECT_NEAR(chebyshev.at(crank_angle).y, 4, 1e-14);
        EXPECT_NEAR(chebyshev.at(crank_angle).x, crank_angle == 90 ? 0 : 4, 1e-14);
    }
}

TEST(ChebyshevLinkage, LeavesTheLineBy0243843PercentOfTheGround) {
    const auto worst = chebyshev.at(73.350564);
    EXPECT_NEAR(worst.x, 0.807576, last_digit);
    EXPECT_NEAR(100 * (worst.y - 4) / 4, 0.243843, last_digit);
    EXPECT_NEAR(chebyshev.speed_at(73.350564).y, 0, 1e-7);
    double high = 4, low = 4;
    for (double crank_angle = std::acos(0.8) / degree; crank_angle < 90; crank_angle += 0.005) {
        high = std::max(high, chebyshev.at(crank_angle).y);
        low = std::min(low, chebyshev.at(crank_angle).y);
    }
    EXPECT_NEAR(high, 4.009754, last_digit);
    EXPECT_NEAR(low, 4, 1e-9);
}

// Levers of length 1, level in the middle position, joined by an upright coupler, drawn by its middle; a lever swings
// by 14 degrees to both sides.
TEST(WattLinkage, StaysNearItsLine) {
    struct Row {
        double coupler, error, travel;
    };
    for (const Row& row : {Row{1, 2.24410e-4, 0.483870}, Row{0.5, 4.59007e-4, 0.483950}}) {
        const double tilt = std::atan2(row.coupler, 2) / degree;
        const Drawn watt{{std::hypot(2, row.coupler), 1, row.coupler, 1}, {row.coupler / 2, 0}, Assembly::open};
        const auto at = [&](double lever) {
            return placed(watt.at(lever - tilt), Placement<double>{{0, 0}, tilt * degree});
        };
        EXPECT_NEAR(at(0).x, 1, 1e-14);
        EXPECT_NEAR(at(0).y, row.coupler / 2, 1e-14);
        double error = 0;
        for (double lever = -14; lever <= 14; lever += 0.01)
            error = std::max(error, std::abs(at(lever).x - 1));
        EXPECT_NEAR(error, row.error, 5.1e-9);
        EXPECT_NEAR(at(14).y - at(-14).y, row.travel, last_digit);
    }
}

// Crank 1, ground L, coupler = rocker = (3 L - 1)/2, the point as far beyond the rocker pin again; half of the band
// that holds the point while the crank turns through `range` about 180 degrees.
TEST(LambdaLinkage, HasTheBandOfChebyshevsCondition) {
    struct Row {
        double range, ground, coupler, half_band, half_digit, stroke;
    };
    const Row table[]{{60, 2.89908, 3.84862, 2.216e-6, 3e-9, 1.76267},
                      {100, 2.72872, 3.59308, 4.901e-5, 6e-9, 2.79160},
                      {120, std::pow((1 + std::sqrt(5.0)) / 2, 2), 3.42705, 1.496e-4, 6e-8, 3.23391},
                      {160, 2.35842, 3.03763, 8.901e-4, 6e-8, 3.93941},
                      {180, 2.21525, 2.82288, 1.871e-3, 6e-7, 4.19321},
                      {180, 2, 2.5, 4.877e-3, 6e-7, 4}};
    for (const Row& row : table) {
        const double coupler = (3 * row.ground - 1) / 2;
        EXPECT_NEAR(coupler, row.coupler, 1.6e-5);
        const Drawn lambda{{row.ground, 1, coupler, coupler}, {2 * coupler, 0}, Assembly::open};
        double low = 1e9, high = -1e9;
        for (int i = 0; i <= 4000; ++i) {
            const double y = lambda.at(180 + row.range * (i / 4000.0 - 0.5)).y;
            low = std::min(low, y);
            high = std::max(high, y);
        }
        EXPECT_NEAR((high - low) / 2, row.half_band, row.half_digit) << row.range;
        const double travel = lambda.at(180 + row.range / 2).x - lambda.at(180 - row.range / 2).x;
        EXPECT_NEAR(std::abs(travel), row.stroke, 1.5e-5) << row.range;
    }
}

}  // namespace
}  // namespace mechwright::test
