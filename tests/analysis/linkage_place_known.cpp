// Known linkages placed by their steps: published poses, exact straight lines, dwells and couplings.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "analysis/linkage/placing/place.h"
#include "analysis/numbers/dual.h"
#include "analysis/numbers/second_dual.h"
#include "tests/analysis/known_linkages.h"
#include "tests/analysis/made_linkage.h"
#include "tests/degree.h"

namespace mechwright::test {
namespace {

using linkage::Group;

TEST(LinkagePlace, IsJansensLeg) {
    const MadeLinkage made = jansen();
    const auto sides = sides_of(made, {{"Y", -1}, {"W", 1}, {"U", -1}});
    const auto foot = [&](double degrees) { return Placed<double>(made, {degrees * degree}, sides)["T"]; };
    const Placed<double> up(made, {90 * degree}, sides);
    ASSERT_TRUE(up.closed);
    EXPECT_NEAR(up["Y"].x, -8.7356523024432949, 1e-12);
    EXPECT_NEAR(up["Y"].y, 40.570166118107246, 1e-12);
    EXPECT_NEAR(up["V"].x, -39.667791263174925, 1e-12);
    EXPECT_NEAR(up["W"].y, -35.430639279698195, 1e-12);
    EXPECT_NEAR(up["U"].x, -19.447599367531681, 1e-12);
    EXPECT_NEAR(up["T"].x, 30.310933769358341, 1e-12);
    EXPECT_NEAR(up["T"].y, -82.589351367404295, 1e-12);
    EXPECT_NEAR(foot(0).x, -5.1601105241047233, 1e-12);
    EXPECT_NEAR(foot(180).y, -65.717097409819483, 1e-12);
    EXPECT_NEAR(foot(270).x, -32.670563176520974, 1e-12);
    EXPECT_EQ(up.order.groups.size(), 4u);

    using Twice = SecondDual<double, 1>;
    const Placed<Twice> moving(made, {Twice::variable(90 * degree, 0)}, sides);
    EXPECT_NEAR(moving["T"].x.first[0], 15.510477033299311, 1e-11);
    EXPECT_NEAR(moving["T"].y.first[0], 3.1037368209964071, 1e-11);
    EXPECT_NEAR(moving["T"].x.second[0], -22.73423027444579, 1e-10);
    EXPECT_NEAR(moving["T"].y.second[0], 2.5151498521023302, 1e-10);
}

TEST(LinkagePlace, IsThePublishedSixBars) {
    struct Row {
        bool watt;
        int first, second;
        double angle, speed, acceleration;
    };
    for (const Row& row : {Row{true, 1, 1, 98.139811596135408, -0.14755136846314872, -0.35806797021778765},
                           Row{true, 1, -1, -58.61360486391257, -0.064484644445962561, -0.21010591796314826},
                           Row{true, -1, 1, 139.8637753829153, -0.26708797835140085, 0.22500981027211678},
                           Row{false, 1, 1, 120.5114867836394, 0.039002770400443418, 0.45003775230586768},
                           Row{false, 1, -1, -114.06234051744652, -0.20648758381964817, -0.10798832800705348},
                           Row{false, -1, 1, 151.97531944496629, -0.13001776319995009, 0.15594770257380817},
                           Row{false, -1, -1, -75.74920012824867, -0.27901431927674766, -0.09589108135814128}}) {
        const MadeLinkage made = six_bar(row.watt);
        using Twice = SecondDual<double, 1>;
        const Placed<Twice> placed(made, {Twice::variable(60 * degree, 0)},
                                   sides_of(made, {{"C", row.first}, {"H", row.second}}));
        ASSERT_TRUE(placed.closed);
        const auto& along = placed.pose.links[5].along;
        const Twice angle = atan2(along.y, along.x);
        EXPECT_NEAR(angle.value / degree, row.angle, 1e-11);
        EXPECT_NEAR(angle.first[0], row.speed, 1e-12);
        EXPECT_NEAR(angle.second[0], row.acceleration, 1e-11);
    }
}

TEST(LinkagePlace, IsExactOnPeaucelliersLine) {
    MadeLinkage m;  // arm 1 about (1, 0), long bars 3 from the origin, short ones 2
    m.points(0, {{"O", 0, 0}, {"M", 1, 0}});
    m.drive(m.link({{"M", 0, 0}, {"P", 1, 0}}));
    const auto bar = [&](const char* a, const char* b, double length) { m.link({{a, 0, 0}, {b, length, 0}}); };
    bar("O", "U", 3);
    bar("O", "V", 3);
    bar("P", "U", 2);
    bar("P", "V", 2);
    bar("U", "Q", 2);
    bar("V", "Q", 2);
    const auto sides = sides_of(m, {{"U", 1}, {"V", -1}, {"Q", 1}});
    const double exact[]{0.44081745177116243, 0.9099255856655059, 1.4433756729740644};
    for (int i = 1; i <= 3; ++i) {
        const Placed<double> placed(m, {i * 20 * degree}, sides);
        ASSERT_TRUE(placed.closed);
        // The pole is a third of the size from the line: the distance of the outer pins, O and Q, is what it is over.
        EXPECT_NEAR(placed["Q"].x, 2.5, 3e-14 * 3 / 2.5);
        EXPECT_NEAR(placed["Q"].y, exact[i - 1], 4e-14);
    }
}

TEST(LinkagePlace, IsExactInScottRussellsLinkage) {
    MadeLinkage m;  // arm 1 about the origin, at the middle of a bar of 2 whose one end slides on the x axis
    m.points(0, {{"O", 0, 0}});
    m.drive(m.link({{"O", 0, 0}, {"M", 1, 0}}));
    m.link({{"M", 0, 0}, {"S", 1, 0}, {"T", -1, 0}});
    m.slot("S", m.line(0, 0, 0, 0));
    for (int degrees = 1; degrees < 90; degrees += 4) {
        const Placed<double> placed(m, {degrees * degree}, {1});
        // What is rounded in the height of M moves S along the line by its tangent.
        const double rounding = 2e-16 * (1 + std::tan(degrees * degree));
        EXPECT_NEAR(placed["T"].x, 0, rounding);
        EXPECT_NEAR(placed["T"].y, 2 * std::sin(degrees * degree), 1e-15);
    }
}

TEST(LinkagePlace, IsHartsInversor) {
    // An antiparallelogram of 4 and 2 with its points at a third: O fixed, OP OQ = 8/3 on either side of O, P on a
    // circle through O.
    MadeLinkage m;
    m.points(0, {{"O", 0, 0}, {"M", 0.8, 0}});
    m.drive(m.link({{"M", 0, 0}, {"P", 0.8, 0}}));
    m.link({{"A", -4. / 3, 0}, {"O", 0, 0}, {"B", 8. / 3, 0}});  // long
    m.link({{"A", -2. / 3, 0}, {"P", 0, 0}, {"D", 4. / 3, 0}});  // short, from A
    m.link({{"C", 0, 0}, {"D", 4, 0}});                          // long
    m.link({{"B", -4. / 3, 0}, {"Q", 0, 0}, {"C", 2. / 3, 0}});  // short; Q a third from C
    const linkage::Order order = linkage::order_of(m.s);
    ASSERT_TRUE(order.closed());
    int found = 0;
    for (int i = 0; i < 4; ++i) {
        const std::vector<std::int8_t> sides{static_cast<std::int8_t>(i % 2 ? 1 : -1),
                                             static_cast<std::int8_t>(i / 2 ? 1 : -1)};
        const Placed<double> placed(m, {50 * degree}, sides);
        if (!placed.closed) continue;
        const auto ac = placed["C"] - placed["A"], bd = placed["D"] - placed["B"];
        if (std::abs(cross(ac, bd)) > 1e-9) continue;  // the parallelogram
        ++found;
        EXPECT_NEAR(std::sqrt(dot(ac, ac) * dot(bd, bd)), 12, 1e-13);
        EXPECT_NEAR(dot(placed["P"], placed["Q"]), -8. / 3, 1e-13);
        EXPECT_NEAR(cross(placed["P"], placed["Q"]), 0, 1e-13);
        EXPECT_NEAR(placed["Q"].x, -8. / 3 / 1.6, 1e-13);
    }
    EXPECT_EQ(found, 2);
}

MadeLinkage five_bar() {
    MadeLinkage m;
    m.points(0, {{"A", 0, 0}, {"E", 3, 0}});
    m.drive(m.link({{"A", 0, 0}, {"B", 1, 0}}));
    m.link({{"E", 0, 0}, {"D", 1.2, 0}});
    m.link({{"B", 0, 0}, {"P", 2.5, 0}});
    m.link({{"D", 0, 0}, {"P", 2.8, 0}});
    return m;
}

TEST(LinkagePlace, IsTheGearedFiveBar) {
    MadeLinkage m = five_bar();
    m.gear(1, 2, 0, -2, 30 * degree);
    using Twice = SecondDual<double, 1>;
    const double at[6][2]{{1.8533584336011551, 2.3498466724026449},  {2.890485678044896, 1.5978575041067967},
                          {0.66104687981868946, 3.0800647310917215}, {1.2738615688137814, 1.039015671619889},
                          {1.2125804154497786, 0.95525665032411256}, {-0.75066617267929666, 1.2986533540259945}};
    for (int i = 0; i < 6; ++i) {
        const Placed<Twice> placed(m, {Twice::variable(i * 60 * degree, 0)}, {1});
        ASSERT_TRUE(placed.closed);
        EXPECT_NEAR(placed["P"].x.value, at[i][0], 1e-13);
        EXPECT_NEAR(placed["P"].y.value, at[i][1], 1e-13);
        if (i != 1) continue;
        EXPECT_NEAR(placed["P"].x.first[0], -0.7329302898839029, 1e-13);
        EXPECT_NEAR(placed["P"].y.first[0], 0.065252790282305744, 1e-13);
        EXPECT_NEAR(placed["P"].x.second[0], -1.9926560761491418, 1e-12);
        EXPECT_NEAR(placed["P"].y.second[0], 3.7271777709588415, 1e-12);
    }
}

TEST(LinkagePlace, TakesTwoDrives) {
    MadeLinkage m = five_bar();
    m.drive(2);
    using Twice = SecondDual<double, 1>;
    Twice second(100 * degree);
    second.first[0] = -0.5;
    const Placed<Twice> placed(m, {Twice::variable(50 * degree, 0), second}, {1});
    EXPECT_NEAR(placed["P"].x.value, 0.90648601886890189, 1e-13);
    EXPECT_NEAR(placed["P"].y.value, 3.2520981732291483, 1e-13);
    EXPECT_NEAR(placed["P"].x.first[0], 0.9791001898035554, 1e-13);
    EXPECT_NEAR(placed["P"].y.second[0], -1.9064255921330628, 1e-12);
}

TEST(LinkagePlace, HasTheDwellOfTheSlottedLever) {
    MadeLinkage m = four_bar_linkage({2, 1, 2.5, 2.5}, 5, 0);
    m.points(0, {{"L", 8, 4}});
    m.link({{"L", 0, 0}});
    m.slot("P", m.line(4, 0, 0, std::numbers::pi));
    const auto lever = [&](double degrees) {
        const Placed<double> placed(m, {degrees * degree}, sides_of(m, {{"C", 1}, {"P", 1}}));
        EXPECT_TRUE(placed.closed);
        const Vector<double>& along = placed.pose.links[4].along;
        return std::atan2(along.y, along.x) / degree;
    };
    for (const double degrees : {90., 180., 270.})
        EXPECT_NEAR(lever(degrees), 0, 1e-12);
    EXPECT_NEAR(std::abs(lever(126.56757623919988)), 0.11683289457576799, 1e-12);
    EXPECT_NEAR(std::abs(lever(8.4793947383342284)), 9.0511782145596195, 1e-12);
}

TEST(LinkagePlace, IsScotchYokeTrammelAndOldhamCoupling) {
    MadeLinkage yoke;
    yoke.points(0, {{"O", 0, 0}});
    yoke.drive(yoke.link({{"O", 0, 0}, {"B", 2, 0}}));
    yoke.slide(yoke.link({}), yoke.line(0, 0, 0, 0));
    yoke.slot("B", yoke.line(2, 0, 0, std::numbers::pi / 2));
    EXPECT_EQ(linkage::order_of(yoke.s).groups.back().kind, Group::Kind::rpp);
    EXPECT_NEAR(Placed<double>(yoke, {0.7}, {}).pose.links[2].origin.x, 2 * std::cos(0.7), 1e-15);

    MadeLinkage trammel;  // driven by its rod's angle
    trammel.drive(trammel.link({{"P", 0, 0}, {"Q", 3, 0}, {"R", 1, 1}}));
    trammel.slot("P", trammel.line(0, 0, 0, 0));
    trammel.slot("Q", trammel.line(0, 0, 0, std::numbers::pi / 2));
    const Placed<double> rod(trammel, {0.7}, {});
    EXPECT_NEAR(rod["P"].x, -3 * std::cos(0.7), 1e-14);
    EXPECT_NEAR(rod["Q"].y, 3 * std::sin(0.7), 1e-14);

    MadeLinkage oldham;  // shafts 0.5 apart, their tongues in square grooves of the disc
    oldham.points(0, {{"A", 0, 0}, {"B", 0.5, 0}});
    oldham.drive(oldham.link({{"A", 0, 0}}));
    const std::size_t second = oldham.link({{"B", 0, 0}}), disc = oldham.link({});
    oldham.slide(disc, oldham.line(1, 0, 0, 0));
    oldham.slide(disc, oldham.line(second, 0, 0, std::numbers::pi / 2));
    const Placed<double> coupling(oldham, {0.7}, {});
    ASSERT_TRUE(coupling.closed);
    const auto centre = coupling.pose.links[disc].origin;
    EXPECT_NEAR(std::hypot(centre.x - 0.25, centre.y), 0.25, 1e-15);  // on the circle over the shafts' distance
    const Vector<double>& along = coupling.pose.links[second].along;
    EXPECT_NEAR(std::atan2(along.y, along.x), 0.7, 1e-15);
}

TEST(LinkagePlace, IsKlannsLeg) {
    // Every link in the axes of its published position, in which the foot is at the origin.
    MadeLinkage m;
    m.points(0, {{"M", 1.599, 0.750}, {"L", 1.009, 0.574}, {"U", 1.366, 1.366}});
    m.drive(m.link({{"M", 0, 0}, {"X", 0.268, 0}}));
    m.link({{"X", 1.331, 0.750}, {"E", 0.741, 0.750}, {"K", 0.232, 0.866}});
    m.link({{"L", 1.009, 0.574}, {"E", 0.741, 0.750}});
    m.link({{"K", 0.232, 0.866}, {"H", 0.866, 1.5}, {"F", 0, 0}});
    m.link({{"U", 1.366, 1.366}, {"H", 0.866, 1.5}});
    const auto sides = sides_of(m, {{"E", -1}, {"H", 1}});
    for (const auto& [degrees, x, y] : {std::array{180., 0., 0.},
                                        {0., 1.0001295030465367, 3.4704035220634677e-5},
                                        {90., 0.49671655705424742, 0.0045807619921161699},
                                        {225., 0.27936903054752927, 0.39813069346223261},
                                        {270., 0.53381618559074872, 0.43522300395018968}}) {
        const Placed<double> placed(m, {degrees * degree}, sides);
        ASSERT_TRUE(placed.closed);
        EXPECT_NEAR(placed["F"].x, x, 1e-13);
        EXPECT_NEAR(placed["F"].y, y, 1e-13);
    }
}

TEST(LinkagePlace, HasChebyshevsDeviation) {
    const MadeLinkage chebyshev = four_bar_linkage({4, 5, 2, 5}, 1, 0);  // levers crossed
    const Placed<double> farthest(chebyshev, {73.350559342972807 * degree}, {-1});
    EXPECT_NEAR(std::abs(farthest["P"].y - 4), 0.0097537330863600058, 1e-13);
    // The lambda linkage has the same curve: its greatest height at a turn of its crank.
    const MadeLinkage lambda = four_bar_linkage({2, 1, 2.5, 2.5}, 5, 0);
    for (const double degrees : {90., 180., 270.})
        EXPECT_NEAR(Placed<double>(lambda, {degrees * degree}, {1})["P"].y, 4, 1e-14);
    using Once = Dual<double, 1>;
    const Placed<Once> highest(lambda, {Once::variable(128.68218745348944 * degree, 0)}, {1});
    EXPECT_NEAR(highest["P"].y.value, 4.00975373308636, 1e-13);
    EXPECT_NEAR(highest["P"].y.partial[0], 0, 1e-12);
    EXPECT_NEAR(Placed<Once>(lambda, {Once::variable(150 * degree, 0)}, {1})["P"].x.partial[0], -1.3353018585808267,
                1e-13);
}

}  // namespace
}  // namespace mechwright::test
