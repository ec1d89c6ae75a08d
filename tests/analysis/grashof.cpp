// Which links turn fully: exercise 2-1 of Theory of Machines, the special linkages, and signs at the last bit.

#include "analysis/four_bar/grashof.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "analysis/four_bar.h"

namespace mechwright::test {
namespace {

FourBarClass kind_with_ground(double ground) { return classify(FourBar<double>{ground, 100, 200, 300}).kind; }

double after(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double before(double x) { return std::nextafter(x, 0); }

// Exercise 2-1: crank 100, coupler 200, rocker 300 mm. Ranges of the ground link, computed from the inequalities:
// assembly 0..600, Grashof 200..400, crank-rocker inside it, double rocker on both sides, never a double crank.
TEST(Grashof, FindsTheRangesOfExercise21) {
    EXPECT_EQ(kind_with_ground(300), FourBarClass::crank_rocker);
    EXPECT_EQ(kind_with_ground(after(200)), FourBarClass::crank_rocker);
    EXPECT_EQ(kind_with_ground(before(400)), FourBarClass::crank_rocker);
    for (const double change : {200.0, 400.0}) {
        EXPECT_EQ(kind_with_ground(change), FourBarClass::crank_rocker);
        EXPECT_TRUE(classify(FourBar<double>{change, 100, 200, 300}).change_point);
    }
    for (const double ground : {1.0, 99.0, 150.0, before(200), after(400), 500.0, before(600), 600.0})
        EXPECT_EQ(kind_with_ground(ground), FourBarClass::triple_rocker) << ground;
    EXPECT_EQ(kind_with_ground(after(600)), FourBarClass::open_chain);
}

TEST(Grashof, NamesTheLinkageByItsShortestLink) {
    const auto kind = [](double ground, double crank, double coupler, double rocker) {
        return classify(FourBar<double>{ground, crank, coupler, rocker}).kind;
    };
    EXPECT_EQ(kind(5, 2, 4, 4), FourBarClass::crank_rocker);
    EXPECT_EQ(kind(2, 5, 4, 4), FourBarClass::double_crank);
    EXPECT_EQ(kind(5, 4, 2, 4), FourBarClass::double_rocker);
    EXPECT_EQ(kind(5, 4, 4, 2), FourBarClass::rocker_crank);
    EXPECT_EQ(kind(7, 3, 4, 5), FourBarClass::triple_rocker);  // 3 + 7 > 4 + 5
    EXPECT_EQ(kind(3, 13, 4, 5), FourBarClass::open_chain);
    EXPECT_EQ(std::string(name_of(kind(5, 2, 4, 4))), "crank-rocker");
    EXPECT_EQ(std::string(name_of(kind(2, 5, 4, 4))), "double crank (drag link)");
}

// The pair of inequalities printed for drag links leaves out the longest crank: this linkage satisfies both and is no
// drag link.
TEST(Grashof, IsNotDeceivedByALongCrank) {
    const FourBar<double> m{3, 10, 4, 5};
    EXPECT_GT(m.coupler, m.ground + m.rocker - m.crank);
    EXPECT_LT(m.coupler, m.crank + m.rocker - m.ground);
    EXPECT_EQ(classify(m).kind, FourBarClass::triple_rocker);
    EXPECT_EQ(grashof_margin(m), -4);
    EXPECT_EQ(double_crank_margins(m).ground_longest, -4);
}

TEST(Grashof, RecognisesParallelogramsKitesAndRhombuses) {
    const Grashof parallelogram = classify(FourBar<double>{4, 2, 4, 2});
    EXPECT_TRUE(parallelogram.change_point && parallelogram.parallelogram && !parallelogram.kite);
    for (const FourBar<double>& m : {FourBar<double>{4, 4, 2, 2}, FourBar<double>{4, 2, 2, 4}}) {
        const Grashof kite = classify(m);
        EXPECT_TRUE(kite.change_point && kite.kite && !kite.parallelogram);
    }
    const Grashof rhombus = classify(FourBar<double>{3, 3, 3, 3});
    EXPECT_TRUE(rhombus.change_point && rhombus.kite && rhombus.parallelogram);
    const Grashof plain_change_point = classify(FourBar<double>{4, 2, 5, 3});
    EXPECT_TRUE(plain_change_point.change_point && !plain_change_point.kite && !plain_change_point.parallelogram);
    EXPECT_FALSE(classify(FourBar<double>{4, 2, 4, 3}).change_point);
}

TEST(Grashof, SeesOneUnitInTheLastPlace) {
    // In decimals both margins are zero; in doubles they differ from it by less than the rounding of either sum.
    const FourBar<double> below{0.8, 0.1, 0.3, 0.6}, above{0.7, 0.2, 0.4, 0.5};
    EXPECT_EQ(grashof_margin(below),
              -0x1.8p-54);  // the doubles exceed 0.8, 0.1, 0.3, 0.6 by 3.2, 0.4, -0.8, -1.6 in 2^-56
    EXPECT_EQ(grashof_margin(above), 0x1p-54);
    EXPECT_EQ(classify(below).kind, FourBarClass::triple_rocker);
    EXPECT_EQ(classify(above).kind, FourBarClass::crank_rocker);
    EXPECT_FALSE(classify(below).change_point || classify(above).change_point);
    for (const double rocker : {before(3), 3.0, after(3)}) {
        const Grashof g = classify(FourBar<double>{4, 2, 5, rocker});
        EXPECT_EQ(g.change_point, rocker == 3);
        EXPECT_EQ(g.kind, rocker < 3 ? FourBarClass::triple_rocker : FourBarClass::crank_rocker);
    }
}

TEST(Grashof, SaysNoToALinkLongerByOneUnitInTheLastPlace) {
    for (const double scale : {1.0, 0x1p-40, 0x1p40, 3.0}) {
        const double a = 0.1 * scale, b = 0.25 * scale, c = 0.375 * scale;
        // The greatest double that the three others reach, found in extended precision.
        const long double reach = static_cast<long double>(a) + b + c;
        double longest = static_cast<double>(reach);
        while (static_cast<long double>(longest) > reach)
            longest = before(longest);
        for (int place = 0; place < 4; ++place) {
            double d[4];
            const double others[3]{a, b, c};
            for (int i = 0, k = 0; i < 4; ++i)
                d[i] = i == place ? longest : others[k++];
            EXPECT_NE(classify(FourBar<double>{d[0], d[1], d[2], d[3]}).kind, FourBarClass::open_chain);
            const auto some = assembled_range(FourBar<double>{d[0], d[1], d[2], d[3]});
            EXPECT_LE(some.from, some.to);
            d[place] = after(longest);
            EXPECT_EQ(classify(FourBar<double>{d[0], d[1], d[2], d[3]}).kind, FourBarClass::open_chain);
            const auto none = assembled_range(FourBar<double>{d[0], d[1], d[2], d[3]});
            EXPECT_GT(none.from, none.to);
        }
    }
}

}  // namespace
}  // namespace mechwright::test
