// Four-bars described as links and joints at the hard places of the built-in ones: as exact as the conditioning allows,
// and margins with all digits where the crank turns fully.

#include <algorithm>
#include <cmath>

#include "analysis/linkage/groups/group_solver.h"
#include "tests/analysis/known_linkages.h"
#include "tests/hard_cases/digits.h"

namespace mechwright::test {
namespace {

/// A four-bar as a linkage at the place of a row whose crank angle is a number.
struct PlacedRow {
    MadeLinkage made;
    Placed<double> placed;

    explicit PlacedRow(const Row& row)
        : made(four_bar_linkage(row.links(), row.number("along"), row.number("across"))),
          placed(made, {row.number("crank_angle")}, {static_cast<std::int8_t>(side_of(row.assembly()))}) {}
};

/// Not those whose crank angle no double is, nor those where the outer pins of the dyad coincide: a linkage has no
/// margins there.
std::vector<Row> rows_of_linkages() {
    std::vector<Row> rows = table("poses.csv");
    std::erase_if(rows, [](const Row& row) {
        const bool pins_meet = row.number("crank_angle") == 0 && row.number("ground") == row.number("crank");
        return row.text("crank_angle") == "pi" || pins_meet;
    });
    return rows;
}

TEST(HardLinkages, AreAsExactAsTheirConditioning) {
    Digits kept("linkages: poses");
    for (const Row& row : rows_of_linkages()) {
        const PlacedRow at(row);
        EXPECT_EQ(at.placed.closed, row.yes("assembled")) << row.label();
        kept.expect(row, "stretch", at.placed.pose.margins[0].outer);
        kept.expect(row, "fold", at.placed.pose.margins[0].inner);
        if (!at.placed.closed) continue;
        const Vector<double> coupler = at.placed.pose.links[2].along, rocker = at.placed.pose.links[3].along;
        kept.expect(row, "coupler_x", coupler.x, 1);
        kept.expect(row, "coupler_y", coupler.y, 1);
        kept.expect(row, "rocker_x", rocker.x, 1);
        kept.expect(row, "rocker_y", rocker.y, 1);
        const double size =
            row.number("ground") + row.number("crank") + std::hypot(row.number("along"), row.number("across"));
        kept.expect(row, "point_x", at.placed["P"].x, size);
        kept.expect(row, "point_y", at.placed["P"].y, size);
    }
}

TEST(HardLinkages, ThatTurnKeepAllDigitsOfTheirMargins) {
    int turning = 0;
    for (const Row& row : rows_of_linkages()) {
        if (!row.yes("turns")) continue;
        ++turning;
        const PlacedRow at(row);
        expect_all_digits(row, "stretch", at.placed.pose.margins[0].outer);
        expect_all_digits(row, "fold", at.placed.pose.margins[0].inner);
    }
    EXPECT_GT(turning, 100);
}

}  // namespace
}  // namespace mechwright::test
