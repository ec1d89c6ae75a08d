// Poses and velocities at change points, toggles, parallelograms, kites, with tiny links, far coupler points and cusps:
// against fifty digits, as exact as the conditioning allows; and with all digits where the formulas promise them.

#include <algorithm>
#include <cmath>

#include "tests/hard_cases/table.h"

namespace mechwright::test {
namespace {

double size_of(const Row& row) {
    return row.number("ground") + row.number("crank") + std::hypot(row.number("along"), row.number("across"));
}

TEST(HardPoses, AssembleWhereTheyShould) {
    const auto rows = table("poses.csv");
    ASSERT_EQ(rows.size(), 376u);
    for (const Row& row : rows)
        EXPECT_EQ(pose(row.links(), row.half(), row.assembly()).assembled(), row.yes("assembled")) << row.label();
}

TEST(HardPoses, AreAsExactAsTheirConditioning) {
    for (const Row& row : table("poses.csv")) {
        const auto m = row.links();
        const auto p = pose(m, row.half(), row.assembly());
        const auto own = [&](const char* column) { return std::abs(row.number(column)); };
        expect_answer(row, "stretch", p.margins.stretch, own("stretch"));
        expect_answer(row, "fold", p.margins.fold, own("fold"));
        expect_answer(row, "transmission_angle", transmission_angle(m, row.half()), own("transmission_angle"));
        expect_answer(row, "transmission_sine", p.transmission_sine, own("transmission_sine"));
        expect_answer(row, "coupler_x", p.coupler.x, 1);
        expect_answer(row, "coupler_y", p.coupler.y, 1);
        expect_answer(row, "rocker_x", p.rocker.x, 1);
        expect_answer(row, "rocker_y", p.rocker.y, 1);
        const auto at = position(m, {row.number("along"), row.number("across")}, p);
        expect_answer(row, "point_x", at.x, size_of(row));
        expect_answer(row, "point_y", at.y, size_of(row));
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
    for (const Row& row : table("poses.csv")) {
        if (!row.has("velocity_ratio")) continue;
        const auto m = row.links();
        const auto p = pose(m, row.half(), row.assembly());
        const auto v = velocity(m, p);
        expect_answer(row, "velocity_ratio", v.rocker, std::max(std::abs(row.number("velocity_ratio")), 1.0));
        const auto moving = velocity(m, {row.number("along"), row.number("across")}, p, v);
        const double scale = size_of(row) * std::max(1.0, std::abs(v.coupler));
        expect_answer(row, "velocity_x", moving.x, scale);
        expect_answer(row, "velocity_y", moving.y, scale);
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
