// Quick returns of Theory of Machines, against values computed anew by closed dyads (the exact columns, not the printed
// ones): every digit that is given. Layouts are those that the digest recovers from the printed answers.

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/quick_return.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {
namespace {

double direction(const Vector<double>& v) { return std::atan2(v.y, v.x) / degree; }
double ratio(const Strokes<double>& s) { return std::max(s.inward / s.outward, s.outward / s.inward); }

TEST(QuickReturnReference, CrankAndCentreDistanceFollowFromTheRatio) {
    for (const double wanted : {1.2, 1.5, 1.6, 2.0, 2.5, 3.0}) {
        const double k = std::cos(180 * degree / (1 + wanted));
        EXPECT_NEAR(ratio(strokes(CrankShaper<double>{1, k, 1, 2, 0.9})), wanted, 1e-12 * wanted);
        EXPECT_NEAR(ratio(strokes(Whitworth<double>{k, 1, 1, 2, 90 * degree})), wanted, 1e-12 * wanted);
    }
}

TEST(QuickReturnReference, ShapersSwingAsTabulated) {
    // Time ratio, half of the lever's swing (deg), crank over centre distance.
    constexpr double table[][3]{{1.2, 8.18182, 0.142315}, {1.5, 18, 0.309017}, {1.6, 20.7692, 0.354605}, {2, 30, 0.5},
                                {2.5, 38.5714, 0.623490}, {3, 45, 0.707107}};
    for (const auto& row : table) {
        const CrankShaper<double> m{1, row[2], 1, 2, 0.9};
        EXPECT_NEAR(direction(greatest_lever_swing(m)), row[1], 5.1e-5);
        EXPECT_NEAR(ratio(strokes(m)), row[0], 2e-5);
    }
    // Exercise M-2-2: a lever of 200 has ratio 2 at stroke 200, and 1.272926 at stroke 75.
    EXPECT_NEAR(ratio(strokes(CrankShaper<double>{100, 18.75, 200, 300, 190})), 1.272926, 5.1e-7);
    EXPECT_NEAR(stroke(CrankShaper<double>{100, 18.75, 200, 300, 190}), 75, 1e-13);
}

TEST(QuickReturnReference, WhitworthOfExercise26) {
    const Whitworth<double> m{90, 180, 96, 490, 90 * degree};
    constexpr double position[]{480.503902, 448.638100, 421.749692, 402.250550, 394,        409.245483,
                                480.503902, 564.169941, 586,        573.980570, 547.443197, 514.633064};
    for (int i = 0; i < 12; ++i)
        EXPECT_NEAR(ram_position(m, i * 30 * degree), position[i], 5.1e-7) << i * 30;
    EXPECT_NEAR(ratio(strokes(m)), 2, 1e-14);
    EXPECT_EQ(stroke(m), 192);
    EXPECT_NEAR(ram_limits(m).outer.crank_angle / degree, 240, 1e-12);
    EXPECT_NEAR(ram_limits(m).inner.crank_angle / degree, 480, 1e-12);
    EXPECT_NEAR(ratio(strokes(Whitworth<double>{90, 108, 96, 490, 90 * degree})), 4.363958, 5.1e-7);
    EXPECT_NEAR(ratio(strokes(Whitworth<double>{90, 180, 96, 490, 0})), 1, 1e-15);  // a slide on the line of centres
}

TEST(QuickReturnReference, WhitworthOfExample32) {
    // O2A = O4B = 20, BC = 65, O2O4 = 12 cm, the crank 60 deg from the line of centres, 1.5 rad/s clockwise. The slide
    // points to the left: the digest's velocities of C count to the right.
    const Whitworth<double> m{12, 20, 20, 65, 90 * degree};
    const auto p = pose(m, half_turn(60 * degree));
    const auto v = velocity(m, p, -1.5);
    const auto a = acceleration(m, p, v);
    EXPECT_NEAR(p.input.reach, 28, 1e-13);
    EXPECT_NEAR(v.input.slide, 11.13461, 5.1e-6);
    EXPECT_NEAR(p.input.reach * v.input.arm, -27.85714, 5.1e-6);
    EXPECT_NEAR(v.input.arm, -0.9948980, 5.1e-8);
    EXPECT_NEAR(m.arm * v.input.arm, -19.89796, 5.1e-6);
    EXPECT_NEAR(v.output.ram, 12.56742, 5.1e-6);
    EXPECT_NEAR(m.rod * v.output.rod, -12.68495, 5.1e-6);
    EXPECT_NEAR(v.output.rod, -0.1951531, 5.1e-8);
    EXPECT_NEAR(p.input.reach * v.input.arm * v.input.arm, 27.71501, 5.1e-6);
    EXPECT_NEAR(std::abs(a.input.coriolis), 22.15561, 5.1e-6);
    EXPECT_NEAR(p.input.reach * a.input.arm, 5.453688, 5.1e-7);
    EXPECT_NEAR(a.input.slide, -14.07070, 5.1e-6);
    EXPECT_NEAR(a.input.arm, 0.1947746, 5.1e-8);
    EXPECT_NEAR(m.arm * std::hypot(a.input.arm, v.input.arm * v.input.arm), 20.17607, 5.1e-6);
    EXPECT_NEAR(m.rod * a.output.rod, 17.89645, 5.1e-6);
    EXPECT_NEAR(a.output.ram, 11.10967, 5.1e-6);
    EXPECT_NEAR(a.output.rod, 0.2753300, 5.1e-8);  // the digest's ...303 contradicts its own 17.89645 = 65 times it
    EXPECT_NEAR(5 * std::abs(v.output.rod - v.input.arm), 3.998724, 5.1e-7);  // rubbing at B, 10 mm pin, mm/s
    EXPECT_NEAR(5 * std::abs(v.input.arm), 4.974490, 5.1e-7);
    EXPECT_NEAR(5 * std::abs(v.output.rod), 0.9757654, 5.1e-8);
    EXPECT_NEAR(ratio(strokes(m)), 2.387910, 5.1e-7);
    EXPECT_EQ(stroke(m), 40);
}

TEST(QuickReturnReference, SlottedLeverOfExample37) {
    // O2 = (0, 0), O4 = (-47, 8), crank 24 cm at 45 deg, 3 rad/s clockwise; the slide on x = -14 points up.
    const Vector<double> centres{47, -8};
    const SlottedArm<double> m{std::hypot(47.0, 8.0), 24};
    const double tilt = std::atan2(centres.y, centres.x);
    const auto p = pose(m, half_turn(45 * degree - tilt));
    const auto v = velocity(m, p, -3.0);
    const auto a = acceleration(m, p, v);
    const Vector<double> arm = turned(p.arm, {std::cos(tilt), std::sin(tilt)});
    const auto s = slide_on_arm(-33.0, Vector<double>{arm.y, -arm.x}, v.arm, a.arm);
    EXPECT_NEAR(m.centre_distance, 47.67599, 5.1e-6);
    EXPECT_NEAR(p.reach, 64.59647, 5.1e-6);
    EXPECT_NEAR(s.reach, 33.32288, 5.1e-6);
    EXPECT_NEAR(p.reach * std::abs(v.arm), 57.48853, 5.1e-6);
    EXPECT_NEAR(std::abs(v.slide), 43.34823, 5.1e-6);
    EXPECT_NEAR(v.arm, -0.8899639, 5.1e-8);
    EXPECT_NEAR(a.arm, -0.8187440, 5.1e-8);
    EXPECT_NEAR(s.reach * std::abs(v.arm), 29.65616, 5.1e-6);
    EXPECT_NEAR(s.velocity, -29.94633, 5.1e-6);
    EXPECT_NEAR(std::abs(s.sliding), 4.158670, 5.1e-7);
    EXPECT_NEAR(p.reach * v.arm * v.arm, 51.16271, 5.1e-6);
    EXPECT_NEAR(std::abs(a.coriolis), 77.15673, 5.1e-6);
    EXPECT_NEAR(p.reach * std::hypot(a.arm, v.arm * v.arm), 73.58506, 5.1e-6);
    EXPECT_NEAR(std::abs(a.slide), 121.3029, 5.1e-5);
    EXPECT_NEAR(std::abs(s.coriolis), 7.402132, 5.1e-7);
    EXPECT_NEAR(s.reach * std::hypot(a.arm, v.arm * v.arm), 37.95976, 5.1e-6);
    EXPECT_NEAR(std::abs(s.acceleration * arm.y + s.reach * v.arm * v.arm), 23.60504, 5.1e-6);
    EXPECT_NEAR(std::abs(s.acceleration), 20.07530, 5.1e-6);
    EXPECT_NEAR(5 * std::abs(v.arm), 4.449820, 5.1e-7);
    const CrankShaper<double> shaper{m.centre_distance, 24, 40, 60, 40};
    EXPECT_NEAR(2 * direction(greatest_lever_swing(shaper)), 60.45014, 5.1e-6);
    EXPECT_NEAR(ratio(strokes(shaper)), 2.011296, 5.1e-7);
}

TEST(QuickReturnReference, SlottedLeverOfExercise44) {
    const SlottedArm<double> m{240, 70};
    for (const double side : {1.0, -1.0}) {  // lever pivot to the left of the crank pivot, then below it
        const auto p = pose(m, half_turn(side * 45 * degree));
        const auto v = velocity(m, p, 10.0);
        const auto a = acceleration(m, p, v);
        EXPECT_NEAR(p.reach, 293.698464, 5.1e-7);
        EXPECT_NEAR(direction(p.arm), side * 9.702455, 5.1e-7);
        EXPECT_NEAR(v.arm, 1.945239, 5.1e-7);
        EXPECT_NEAR(a.arm, -side * 8.413916, 5.1e-7);
        EXPECT_NEAR(p.reach * v.arm, 571.313642, 5.1e-7);
        EXPECT_NEAR(p.reach * std::abs(a.arm), 2471.154, 5.1e-4);
        EXPECT_NEAR(p.reach * v.arm * v.arm, 1111.341, 5.1e-4);
        EXPECT_NEAR(p.reach * std::hypot(a.arm, v.arm * v.arm), 2709.554, 5.1e-4);
        EXPECT_NEAR(std::abs(v.slide), 404.4759, 5.1e-5);
        EXPECT_NEAR(a.slide, -4601.795, 5.1e-4);
        EXPECT_NEAR(std::abs(a.coriolis), 1573.604, 5.1e-4);
    }
    EXPECT_NEAR(ratio(strokes(CrankShaper<double>{240, 70, 100, 200, 95})), 1.464328, 5.1e-7);
}

/// The length of the acceleration of a point at `arm` from a fixed pivot.
Vector<double> acceleration_at(const Vector<double>& arm, double velocity, double acceleration) {
    return left_of(acceleration * arm) - (velocity * velocity) * arm;
}

double length(const Vector<double>& v) { return std::hypot(v.x, v.y); }

TEST(QuickReturnReference, DragLinkOfExampleW51) {
    // O2A 100, AB 150, O4B 125, O2O4 65, O4C 200, CD 375 mm, slide on the ground line, crank at 90 deg, 50 rad/s.
    const DragLink<double> m{{0.065, 0.1, 0.15, 0.125}, 0.2, 0, 0.375, 0, 0};
    const auto p = pose(m, half_turn(90 * degree));
    const auto v = velocity(m, p, 50.0);
    const auto a = acceleration(m, p, v);
    EXPECT_NEAR(direction(p.input.rocker), 47.29, 5.1e-3);
    EXPECT_NEAR(1000 * p.output.position + 65, 545.646, 5.1e-4);
    EXPECT_NEAR(v.input.coupler, 29.3382, 5.1e-5);
    EXPECT_NEAR(v.input.rocker, 51.8318, 5.1e-5);
    EXPECT_NEAR(v.output.rod, -20.3791, 5.1e-5);
    EXPECT_NEAR(v.output.ram, -10.6128, 5.1e-5);
    EXPECT_NEAR(a.input.coupler, -604.034, 5.1e-4);
    EXPECT_NEAR(a.input.rocker, -1022.50, 5.1e-3);
    EXPECT_NEAR(a.output.rod, 1369.57, 5.1e-3);
    EXPECT_NEAR(std::abs(a.output.ram), 156.137, 5.1e-4);
    // Mass centres in the middles of crank, coupler, arm and rod.
    const auto crank_pin = acceleration_at(m.links.crank * p.input.crank, 50, 0);
    const auto coupler = crank_pin + acceleration_at(0.075 * p.input.coupler, v.input.coupler, a.input.coupler);
    const auto arm_pin = acceleration_at(m.arm * p.output.crank, v.output.crank, a.output.crank);
    EXPECT_NEAR(length(0.5 * crank_pin), 125, 1e-12);
    EXPECT_NEAR(length(coupler), 299.308, 5.1e-4);
    EXPECT_NEAR(length(0.5 * arm_pin), 287.454, 5.1e-4);
    EXPECT_NEAR(length(0.5 * (arm_pin + Vector<double>{a.output.ram, 0})), 324.719, 5.1e-4);
    EXPECT_NEAR(ratio(strokes(m)), 2.84068, 5.1e-6);
    EXPECT_NEAR(strokes(m).inward / degree, 266.267, 5.1e-4);
    EXPECT_NEAR(stroke(m), 0.4, 1e-15);
    EXPECT_NEAR(ram_limits(m).outer.crank_angle / degree, 51.6070, 5.1e-5);
    EXPECT_NEAR(ram_limits(m).inner.crank_angle / degree, 317.874, 5.1e-4);
    EXPECT_NEAR(ram_limits(m).outer.position, 0.575, 1e-15);
    EXPECT_NEAR(transmission_angle(m.links, HalfTurn<double>{1, 0}) / degree, 10.2631, 5.1e-5);
    EXPECT_NEAR(transmission_angle(m.links, HalfTurn<double>{0, 1}) / degree, 73.1021, 5.1e-5);
}

TEST(QuickReturnReference, DragLinkOnFourSlideLines) {
    constexpr double table[][2]{{0, 1.634781}, {30, 1.998294}, {60, 1.926842}, {90, 1.592018}};
    for (const auto& row : table) {
        const DragLink<double> m{{30, 60, 70, 80}, 50, 0, 150, row[0] * degree, 0};
        EXPECT_NEAR(ratio(strokes(m)), row[1], 5.1e-7) << row[0];
        EXPECT_NEAR(stroke(m), 100, 1e-13);
        // An arm at an angle to the follower is as good as a slide line at that angle.
        const DragLink<double> bent{{30, 60, 70, 80}, 50, -row[0] * degree, 150, 0, 0};
        EXPECT_NEAR(ratio(strokes(bent)), row[1], 5.1e-7) << row[0];
    }
    const DragLink<double> m{{30, 60, 70, 80}, 50, 0, 150, 30 * degree, 0};
    EXPECT_NEAR(ram_limits(m).outer.crank_angle / degree, 59.687176, 5.1e-7);
    EXPECT_NEAR(ram_limits(m).inner.crank_angle / degree, 299.618887, 5.1e-7);
}

TEST(QuickReturnReference, FourBarOfExercise48) {
    const double pin_x = 381 * std::cos(30 * degree), pin_y = 190.5;
    const FourBar<double> m{762, 381, std::hypot(762 - pin_x, 254 - pin_y), 254};
    EXPECT_NEAR(m.coupler, 436.685866, 5.1e-7);
    const auto p = pose(m, 30 * degree, Assembly::open);
    EXPECT_NEAR(direction(p.rocker), 90, 1e-12);
    EXPECT_NEAR(direction(p.coupler), 8.361222, 5.1e-7);
    const double turn = 120 * degree - std::atan2(p.coupler.y, p.coupler.x);
    const CouplerPoint<double> point{254 * std::cos(turn), 254 * std::sin(turn)};
    const auto v = velocity(m, p, -200.0);
    const auto a = acceleration(m, p, v);
    EXPECT_NEAR(v.coupler, 152.741588, 5.1e-7);
    EXPECT_NEAR(v.rocker, -111.814603, 5.1e-7);
    EXPECT_NEAR(a.coupler, 13715.76, 5.1e-3);
    EXPECT_NEAR(a.rocker, 95073.89, 5.1e-3);
    EXPECT_NEAR(length(velocity(m, point, p, v)), 85507.882, 5.1e-4);
    EXPECT_NEAR(length(acceleration(m, point, p, v, a)), 1.963915e7, 5.1);
}

}  // namespace
}  // namespace mechwright::test
