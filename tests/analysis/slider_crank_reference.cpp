// Slider-cranks of Theory of Machines and of the linkage digest, against values computed anew from the loop equations
// (the exact columns, not the printed ones): every digit that is given.

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/slider_crank.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {
namespace {

double direction(const Vector<double>& v) { return std::atan2(v.y, v.x) / degree; }
double ratio(const Strokes<double>& s) { return std::max(s.inward / s.outward, s.outward / s.inward); }

TEST(SliderCrankReference, HasTheStrokesOfOffsetMechanisms) {
    struct Row {
        SliderCrank<double> m;
        double ratio, stroke, last_digit;
    };
    constexpr Row table[]{
        {{1, 3, 0.8}, 1.14338303, 2.08615331, 5.1e-9}, {{2, 5, 2.5}, 1.49165741, 4.88003602, 5.1e-9},
        {{50, 150, 20}, 1.066564, 101.017898, 5.1e-7}, {{2, 5, 1}, 1.133435, 4.099776, 5.1e-7},
        {{30, 100, 30}, 1.143298, 63.245553, 5.1e-7},  {{100, 300, 0}, 1, 200, 1e-13},
    };
    for (const Row& row : table) {
        for (const double side : {1.0, -1.0}) {
            const SliderCrank<double> m{row.m.crank, row.m.rod, side * row.m.offset};
            EXPECT_NEAR(ratio(strokes(m)), row.ratio, row.last_digit);
            EXPECT_NEAR(stroke(m), row.stroke, row.last_digit);
            // The slow stroke is the inward one for a slide line on the left, the outward one on the right.
            if (m.offset != 0) {
                EXPECT_EQ(strokes(m).inward > strokes(m).outward, side > 0);
            }
        }
    }
    const auto s = strokes(SliderCrank<double>{50, 150, 20});
    EXPECT_NEAR(s.inward / degree, 185.797789, 5.1e-7);
}

TEST(SliderCrankReference, MovesAsExample43Tabulates) {
    // a = 200, b = 750, e = 50 mm, 20 rad/s, 10 rad/s^2: th, BET, VS (m/s), VB (rad/s), ACS (m/s^2), ACB (rad/s^2), x.
    constexpr double table[][7]{
        {0, 3.822554, 0.267261, -5.345225, -101.342719, -0.763604, 948.331477},
        {30, -3.822554, -2.231455, -4.629100, -83.832410, 49.705941, 921.536558},
        {60, -9.455030, -3.797173, -2.703393, -35.917382, 91.079474, 839.811130},
        {90, -11.536959, -4.000000, 0.000000, 14.329932, 108.866211, 734.846923},
        {120, -9.455030, -3.131030, 2.703393, 44.415689, 93.782867, 639.811130},
        {150, -3.822554, -1.768545, 4.629100, 54.963110, 54.335042, 575.126397},
        {180, 3.822554, -0.267261, 5.345225, 58.390020, 4.581621, 548.331477},
        {210, 11.536959, 1.292893, 4.714045, 61.083099, -47.539991, 561.641842},
        {240, 17.313917, 2.840638, 2.793232, 56.888393, -92.931605, 616.016405},
        {270, 19.471221, 4.000000, 0.000000, 30.284271, -113.137085, 707.106781},
        {300, 17.313917, 4.087565, -2.793232, -22.488143, -95.724837, 816.016405},
        {330, 11.536959, 2.707107, -4.714045, -76.773859, -52.254036, 908.052004},
    };
    constexpr double last_digit = 5.1e-7;
    const SliderCrank<double> m{200, 750, 50};
    for (const auto& row : table) {
        const auto p = pose(m, row[0] * degree);
        const auto v = velocity(m, p, 20.0);
        const auto a = acceleration(m, p, v, 10.0);
        ASSERT_TRUE(p.assembled());
        EXPECT_NEAR(direction(p.rod), row[1], last_digit) << row[0];
        EXPECT_NEAR(v.ram / 1000, row[2], last_digit) << row[0];
        EXPECT_NEAR(v.rod, row[3], last_digit) << row[0];
        EXPECT_NEAR(a.ram / 1000, row[4], last_digit) << row[0];
        EXPECT_NEAR(a.rod, row[5], last_digit) << row[0];
        EXPECT_NEAR(p.position, row[6], last_digit) << row[0];
        EXPECT_NEAR(transmission_angle(p) / degree, 90 - std::abs(row[1]), last_digit) << row[0];
    }
}

TEST(SliderCrankReference, MovesAsExercise43OnBothSides) {
    struct Row {
        double offset, rod_angle, position, rod_velocity, rod_acceleration, ram_velocity, ram_acceleration;
    };
    constexpr Row table[]{{200, 10.828387, 597.163163, -2.159777, 18.170436, -857.783745, -16725.5326},
                          {-200, -37.743823, 501.443803, -2.682650, 15.890229, -1881.728139, -10709.8429}};
    for (const Row& row : table) {
        const SliderCrank<double> m{150, 500, row.offset};
        const auto p = pose(m, 45 * degree);
        const auto v = velocity(m, p, 10.0);
        const auto a = acceleration(m, p, v, 20.0);
        EXPECT_NEAR(direction(p.rod), row.rod_angle, 5.1e-7);
        EXPECT_NEAR(p.position, row.position, 5.1e-7);
        EXPECT_NEAR(v.rod, row.rod_velocity, 5.1e-7);
        EXPECT_NEAR(a.rod, row.rod_acceleration, 5.1e-7);
        EXPECT_NEAR(v.ram, row.ram_velocity, 5.1e-7);
        EXPECT_NEAR(a.ram, row.ram_acceleration, 5.1e-5);
    }
}

TEST(SliderCrankReference, MovesAsExample41) {
    const SliderCrank<double> m{50.8, 203.2, 0};
    const CouplerPoint<double> centre{50.8, 0};
    const auto p = pose(m, 30 * degree);
    EXPECT_NEAR(direction(p.rod), -7.180756, 5.1e-7);
    EXPECT_NEAR(p.position, 245.6003, 5.1e-5);
    struct Row {
        double speed, rod_velocity, rod_acceleration, x, y, size, ram_velocity, ram_acceleration;
    };
    const Row table[]{{314, -68.52042, 11830.41, -4499156, -1878254, 4875474, -9716.019, -4983700},
                      {100 * std::numbers::pi, -68.55517, 11842.41, -4503721, -1880160, 4880421, -9720.947, -4988757}};
    for (const Row& row : table) {
        const auto v = velocity(m, p, row.speed);
        const auto a = acceleration(m, p, v);
        const auto g = acceleration(m, centre, p, v, a);
        EXPECT_NEAR(v.rod, row.rod_velocity, 5.1e-6);
        EXPECT_NEAR(a.rod, row.rod_acceleration, 5.1e-3);
        EXPECT_NEAR(g.x, row.x, 0.51);
        EXPECT_NEAR(g.y, row.y, 0.51);
        EXPECT_NEAR(std::hypot(g.x, g.y), row.size, 0.51);
        EXPECT_NEAR(direction(g) + 360, 202.6590, 5.1e-5);
        EXPECT_NEAR(v.ram, row.ram_velocity, 5.1e-4);
        EXPECT_NEAR(a.ram, row.ram_acceleration, 0.51);
    }
}

TEST(SliderCrankReference, MovesItsRodsCentreAsExample41OverTheTurn) {
    const SliderCrank<double> m{50.8, 203.2, 0};
    const CouplerPoint<double> centre{50.8, 0};
    // Crank angle, size (mm/s^2), direction; at 100 pi rad/s.
    constexpr double table[][3]{{0, 5.32712e6, 180},       {60, 4.01610e6, 234.181},  {90, 3.77422e6, 274.919},
                                {120, 4.20699e6, 309.279}, {150, 4.58372e6, 335.784}, {180, 4.70040e6, 0}};
    for (const auto& row : table) {
        const auto p = pose(m, row[0] * degree);
        const auto v = velocity(m, p, 100 * std::numbers::pi);
        const auto g = acceleration(m, centre, p, v, acceleration(m, p, v));
        EXPECT_NEAR(std::hypot(g.x, g.y), row[1], 5.1) << row[0];
        EXPECT_NEAR(std::remainder(direction(g) - row[2], 360), 0, 5.1e-4) << row[0];
    }
}

}  // namespace
}  // namespace mechwright::test
