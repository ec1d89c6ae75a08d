// Slotted arms and slider-cranks at hard places: crank and centre distance nearly equal, a rod with nothing to spare, a
// ram that comes back to the crank pivot, sizes a million apart; against fifty digits.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/quick_return.h"
#include "tests/hard_cases/digits.h"

namespace mechwright::test {
namespace {

TEST(HardSlottedArms, KeepAllDigits) {
    const auto rows = table("slotted_arms.csv");
    ASSERT_EQ(rows.size(), 80u);
    Digits kept("slotted arms: motion");
    for (const Row& row : rows) {
        const SlottedArm<double> m{row.number("centre_distance"), row.number("crank")};
        const auto p = pose(m, row.half());
        const auto v = velocity(m, p);
        kept.expect(row, "arm_angle", std::atan2(p.arm.y, p.arm.x));
        kept.expect(row, "reach", p.reach);
        kept.expect(row, "arm_velocity", v.arm);
        kept.expect(row, "arm_acceleration", acceleration(m, p, v).arm);
        kept.expect(row, "slide_velocity", v.slide);
    }
}

TEST(HardSlottedArms, HaveStrokesToAllDigits) {
    const auto rows = table("slotted_strokes.csv");
    ASSERT_EQ(rows.size(), 18u);
    Digits kept("slotted arms: strokes");
    for (const Row& row : rows) {
        const double d = row.number("centre_distance"), r = row.number("crank");
        const Strokes<double> s = r < d ? strokes(CrankShaper<double>{d, r, 1, 2, 0.5})
                                        : strokes(Whitworth<double>{d, r, 1, 2, std::numbers::pi / 2});
        kept.expect(row, "slow_stroke", std::max(s.outward, s.inward));
        kept.expect(row, "fast_stroke", std::min(s.outward, s.inward));
    }
}

SliderCrank<double> slider_crank_of(const Row& row) {
    return {row.number("crank"), row.number("rod"), row.number("offset")};
}

TEST(HardSliderCranks, KeepAllDigits) {
    const auto rows = table("slider_cranks.csv");
    ASSERT_EQ(rows.size(), 216u);
    Digits kept("slider-cranks: motion");
    for (const Row& row : rows) {
        const SliderCrank<double> m = slider_crank_of(row);
        const auto p = pose(m, row.number("crank_angle"));
        ASSERT_TRUE(p.assembled()) << row.label();
        kept.expect(row, "position", p.position);
        kept.expect(row, "rod_slope", std::atan2(p.rod.y, p.rod.x));
        kept.expect(row, "transmission_angle", transmission_angle(p));
        const auto v = velocity(m, p);
        kept.expect(row, "velocity", v.ram);
        kept.expect(row, "acceleration", acceleration(m, p, v).ram);
    }
}

TEST(HardSliderCranks, HaveStrokesToAllDigits) {
    const auto rows = table("slider_strokes.csv");
    ASSERT_EQ(rows.size(), 27u);
    Digits kept("slider-cranks: strokes");
    for (const Row& row : rows) {
        const SliderCrank<double> m = slider_crank_of(row);
        kept.expect(row, "stroke", stroke(m));
        kept.expect(row, "inward_stroke", strokes(m).inward);
    }
}

/// The ram of a drive that stands in a row, on the scale of what moves it.
template <class Drive>
void expect_ram(Digits& kept, const Row& row, const Drive& m, const HalfTurn<double>& half) {
    const auto p = pose(m, half);
    const auto v = velocity(m, p);
    const double arm = output_of(m).crank, rod = output_of(m).rod;
    const double speed = std::abs(ram_of(v).crank), rod_speed = std::abs(ram_of(v).rod);
    const auto a = acceleration(m, p, v);
    kept.expect(row, "position", ram_of(p).position, arm + rod);
    kept.expect(row, "transmission_angle", transmission_angle(ram_of(p)));
    kept.expect(row, "velocity", ram_of(v).ram, arm * speed + rod * rod_speed);
    kept.expect(row, "acceleration", ram_of(a).ram,
                arm * (speed * speed + std::abs(ram_of(a).crank)) + rod * rod_speed * rod_speed);
}

TEST(HardCrankShapers, MoveTheirRamsAsExactlyAsTheirConditioningAllows) {
    const auto rows = table("crank_shapers.csv");
    ASSERT_EQ(rows.size(), 90u);
    Digits kept("crank shapers: ram");
    for (const Row& row : rows)
        expect_ram(kept, row,
                   CrankShaper<double>{row.number("centre_distance"), row.number("crank"), row.number("lever"),
                                       row.number("rod"), row.number("ram_distance")},
                   row.half());
}

TEST(HardWhitworths, MoveTheirRamsAsExactlyAsTheirConditioningAllows) {
    const auto rows = table("whitworths.csv");
    ASSERT_EQ(rows.size(), 144u);
    Digits kept("Whitworth drives: ram");
    for (const Row& row : rows)
        expect_ram(kept, row,
                   Whitworth<double>{row.number("centre_distance"), row.number("crank"), row.number("arm"),
                                     row.number("rod"), row.number("slide_angle")},
                   row.half());
}

DragLink<double> drag_link_of(const Row& row) {
    return {{row.number("ground"), row.number("crank"), row.number("coupler"), row.number("follower")},
            row.number("arm"),
            row.number("arm_angle"),
            row.number("rod"),
            row.number("slide_angle"),
            row.number("offset"),
            row.assembly()};
}

TEST(HardDragLinks, MoveTheirRamsAsExactlyAsTheirConditioningAllows) {
    const auto rows = table("drag_links.csv");
    ASSERT_EQ(rows.size(), 324u);
    Digits kept("drag links: ram");
    for (const Row& row : rows)
        expect_ram(kept, row, drag_link_of(row), row.half());
}

TEST(HardDragLinks, HaveStrokesAsExactAsTheirConditioningAllows) {
    const auto rows = table("drag_strokes.csv");
    ASSERT_EQ(rows.size(), 54u);
    Digits kept("drag links: strokes");
    for (const Row& row : rows) {
        const auto m = drag_link_of(row);
        const auto both = strokes(m);
        kept.expect(row, "outward_stroke", both.outward);
        kept.expect(row, "inward_stroke", both.inward);
        kept.expect(row, "stroke", stroke(m));
    }
}

}  // namespace
}  // namespace mechwright::test
