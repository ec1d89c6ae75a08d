// Limit positions, swing and stroke at change points and with the smallest cranks, against fifty digits.

#include <cmath>

#include "analysis/four_bar.h"
#include "tests/hard_cases/digits.h"

namespace mechwright::test {
namespace {

TEST(HardLimits, KeepAllDigits) {
    const auto rows = table("limits.csv");
    ASSERT_EQ(rows.size(), 46u);
    Digits kept("four-bars: limit positions");
    for (const Row& row : rows) {
        const auto m = row.links();
        kept.expect(row, "swing", swing(m));
        expect_all_digits(row, "swing", swing(m));
        const auto limits = limit_positions(m, Assembly::open);
        expect_all_digits(row, "extended_crank", limits.extended.crank_angle);
        expect_all_digits(row, "folded_crank", limits.folded.crank_angle);
        expect_all_digits(row, "extended_rocker", limits.extended.rocker_angle);
        expect_all_digits(row, "folded_rocker", limits.folded.rocker_angle);
        expect_all_digits(row, "extended_transmission", limits.extended.transmission_angle);
        expect_all_digits(row, "folded_transmission", limits.folded.transmission_angle);
    }
}

TEST(HardLimits, HaveAStrokeAsExactAsItsConditioning) {
    Digits kept("four-bars: strokes");
    for (const Row& row : table("limits.csv"))
        kept.expect(row, "stroke_excess", stroke_excess(row.links()));
}

TEST(HardFrames, KeepTheirDigitsAMillionSizesAway) {
    const auto rows = table("frames.csv");
    ASSERT_EQ(rows.size(), 18u);
    for (const Row& row : rows) {
        const auto local = position(row.links(), CouplerPoint<double>{row.number("along"), row.number("across")},
                                    pose(row.links(), row.half(), Assembly::open));
        const auto off = miss(local, {{row.number("origin_x"), row.number("origin_y")}, row.number("tilt")},
                              {row.number("target_x"), row.number("target_y")});
        EXPECT_LE(abs(Precise(off.x) - row.exact("miss_x")), 1e-15) << row.label();
        EXPECT_LE(abs(Precise(off.y) - row.exact("miss_y")), 1e-15) << row.label();
    }
}

}  // namespace
}  // namespace mechwright::test
