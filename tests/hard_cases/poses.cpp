// Poses and velocities at change points, toggles, parallelograms, kites, with tiny links, far coupler points and cusps:
// against fifty digits, as exact as the conditioning allows; and with all digits where the formulas promise them.

#include <algorithm>
#include <cmath>

#include "tests/hard_cases/digits.h"

namespace mechwright::test {
namespace {

double size_of(const Row& row) {
    return row.number("ground") + row.number("crank") + std::hypot(row.number("along"), row.number("across"));
}

TEST(HardPoses, AssembleWhereTheyShould) {
    const auto rows = table("poses.csv");
    ASSERT_EQ(rows.size(), 456u);
    for (const Row& row : rows)
        EXPECT_EQ(pose(row.links(), row.half(), row.assembly()).assembled(), row.yes("assembled")) << row.label();
}

TEST(HardPoses, AreAsExactAsTheirConditioning) {
    Digits kept("four-bars: poses");
    for (const Row& row : table("poses.csv")) {
        const auto m = row.links();
        const auto p = pose(m, row.half(), row.assembly());
        kept.expect(row, "stretch", p.margins.stretch);
        kept.expect(row, "fold", p.margins.fold);
        kept.expect(row, "transmission_angle", transmission_angle(m, row.half()));
        kept.expect(row, "transmission_sine", p.transmission_sine);
        kept.expect(row, "coupler_x", p.coupler.x, 1);
        kept.expect(row, "coupler_y", p.coupler.y, 1);
        kept.expect(row, "rocker_x", p.rocker.x, 1);
        kept.expect(row, "rocker_y", p.rocker.y, 1);
        const auto at = position(m, {row.number("along"), row.number("across")}, p);
        kept.expect(row, "point_x", at.x, size_of(row));
        kept.expect(row, "point_y", at.y, size_of(row));
    }
}

// Where the crank turns fully nothing cancels: the margins, the transmission angle and its sine keep all digits,
// however close the change point.
TEST(HardPoses, OfTurningLinkagesKeepAllDigitsAtChangePoints) {
    int turning = 0;
    for (const Row& row : table("poses.csv")) {
        if (!row.yes("turns")) continue;
        ++turning;
        const auto m = row.links();
        const auto p = pose(m, row.half(), row.assembly());
        expect_all_digits(row, "stretch", p.margins.stretch);
        expect_all_digits(row, "fold", p.margins.fold);
        expect_all_digits(row, "transmission_angle", transmission_angle(m, row.half()));
        expect_all_digits(row, "transmission_sine", p.transmission_sine);
    }
    EXPECT_GT(turning, 150);
}

TEST(HardPoses, MoveAsFastAsTheirConditioningAllows) {
    Digits kept("four-bars: velocities");
    for (const Row& row : table("poses.csv")) {
        if (!row.has("velocity_ratio")) continue;
        const auto m = row.links();
        const auto p = pose(m, row.half(), row.assembly());
        const auto v = velocity(m, p);
        kept.expect(row, "velocity_ratio", v.rocker, std::max(std::abs(row.number("velocity_ratio")), 1.0));
        const auto moving = velocity(m, {row.number("along"), row.number("across")}, p, v);
        const double scale = size_of(row) * std::max(1.0, std::abs(v.coupler));
        kept.expect(row, "velocity", moving, scale);
    }
}

TEST(HardPoses, AccelerateAsTheirConditioningAllows) {
    Digits kept("four-bars: accelerations");
    for (const Row& row : table("poses.csv")) {
        if (!row.has("ratio_slope")) continue;
        const auto m = row.links();
        const CouplerPoint<double> point{row.number("along"), row.number("across")};
        const auto p = pose(m, row.half(), row.assembly());
        const auto v = velocity(m, p);
        const auto a = acceleration(m, p, v);
        kept.expect(row, "ratio_slope", a.rocker, std::max({std::abs(a.rocker), v.rocker * v.rocker, 1.0}));
        const auto moving = acceleration(m, point, p, v, a);
        const double scale = size_of(row) * std::max({1.0, std::abs(a.coupler), v.coupler * v.coupler});
        kept.expect(row, "acceleration", moving, scale);
    }
}

TEST(HardPoses, StandStillAtTheCuspsOfTheirCurves) {
    int cusps = 0;
    for (const Row& row : table("poses.csv")) {
        if (row.text("name") != "cusp of the coupler curve") continue;
        ++cusps;
        const auto p = pose(row.links(), row.half(), row.assembly());
        const auto moving =
            velocity(row.links(), {row.number("along"), row.number("across")}, p, velocity(row.links(), p));
        EXPECT_LE(std::hypot(moving.x, moving.y), 1e-14 * size_of(row)) << row.label();
    }
    EXPECT_EQ(cusps, 6);
}

TEST(HardAssemblies, SayNoAndYesAtTheLastUnit) {
    const auto rows = table("assembly.csv");
    ASSERT_GT(rows.size(), 50u);
    for (const Row& row : rows)
        for (const Assembly assembly : {Assembly::open, Assembly::crossed})
            EXPECT_EQ(pose(row.links(), row.half(), assembly).assembled(), row.yes("assembles")) << row.label();
}

}  // namespace
}  // namespace mechwright::test
