// Slotted arms and slider-cranks at hard places: crank and centre distance nearly equal, a rod with nothing to spare, a
// ram that comes back to the crank pivot, sizes a million apart; against fifty digits.

#include <cmath>

#include "analysis/quick_return.h"
#include "tests/hard_cases/table.h"

namespace mechwright::test {
namespace {

double size_of(const Row& row, const std::string& column) { return std::abs(row.number(column)); }

TEST(HardSlottedArms, KeepAllDigits) {
    const auto rows = table("slotted_arms.csv");
    ASSERT_EQ(rows.size(), 80u);
    for (const Row& row : rows) {
        const SlottedArm<double> m{row.number("centre_distance"), row.number("crank")};
        const auto p = pose(m, row.half());
        const auto v = velocity(m, p);
        expect_answer(row, "arm_angle", std::atan2(p.arm.y, p.arm.x), size_of(row, "arm_angle"));
        expect_answer(row, "reach", p.reach, size_of(row, "reach"));
        expect_answer(row, "arm_velocity", v.arm, size_of(row, "arm_velocity"));
        expect_answer(row, "arm_acceleration", acceleration(m, p, v).arm, size_of(row, "arm_acceleration"));
        expect_answer(row, "slide_velocity", v.slide, size_of(row, "slide_velocity"));
    }
}

TEST(HardSlottedArms, HaveStrokesToAllDigits) {
    const auto rows = table("slotted_strokes.csv");
    ASSERT_EQ(rows.size(), 18u);
    for (const Row& row : rows) {
        const double d = row.number("centre_distance"), r = row.number("crank");
        const Strokes<double> s = r < d ? strokes(CrankShaper<double>{d, r, 1, 2, 0.5})
                                        : strokes(Whitworth<double>{d, r, 1, 2, std::numbers::pi / 2});
        expect_answer(row, "slow_stroke", std::max(s.outward, s.inward), size_of(row, "slow_stroke"));
        expect_answer(row, "fast_stroke", std::min(s.outward, s.inward), size_of(row, "fast_stroke"));
    }
}

SliderCrank<double> slider_crank_of(const Row& row) {
    return {row.number("crank"), row.number("rod"), row.number("offset")};
}

TEST(HardSliderCranks, KeepAllDigits) {
    const auto rows = table("slider_cranks.csv");
    ASSERT_EQ(rows.size(), 216u);
    for (const Row& row : rows) {
        const SliderCrank<double> m = slider_crank_of(row);
        const auto p = pose(m, row.number("crank_angle"));
        ASSERT_TRUE(p.assembled()) << row.label();
        expect_answer(row, "position", p.position, size_of(row, "position"));
        expect_answer(row, "rod_slope", std::atan2(p.rod.y, p.rod.x), size_of(row, "rod_slope"));
        expect_answer(row, "transmission_angle", transmission_angle(p), size_of(row, "transmission_angle"));
        expect_answer(row, "velocity", velocity(m, p).ram, size_of(row, "velocity"));
    }
}

TEST(HardSliderCranks, HaveStrokesToAllDigits) {
    const auto rows = table("slider_strokes.csv");
    ASSERT_EQ(rows.size(), 27u);
    for (const Row& row : rows) {
        const SliderCrank<double> m = slider_crank_of(row);
        expect_answer(row, "stroke", stroke(m), size_of(row, "stroke"));
        expect_answer(row, "inward_stroke", strokes(m).inward, size_of(row, "inward_stroke"));
    }
}

}  // namespace
}  // namespace mechwright::test
