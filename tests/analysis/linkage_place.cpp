// Linkages placed by their steps: the built-in kinds, and random six-bars against Newton in fifty digits.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "analysis/four_bar.h"
#include "analysis/linkage/placing/place.h"
#include "analysis/quick_return.h"
#include "analysis/slider_crank.h"
#include "tests/analysis/known_linkages.h"
#include "tests/analysis/made_linkage.h"

namespace mechwright::test {
namespace {

using linkage::Group;

double direction(const Vector<double>& v) { return std::atan2(v.y, v.x); }

struct Draw {
    std::mt19937_64 engine;
    double operator()(double from, double to) {
        return from + (to - from) * (static_cast<double>(engine() >> 11) * 0x1p-53);
    }
};

TEST(LinkagePlace, IsTheFourBarsPose) {
    Draw draw{std::mt19937_64(1)};
    int compared = 0;
    for (int i = 0; i < 500; ++i) {
        const FourBar<double> m{draw(1, 10), draw(1, 10), draw(1, 10), draw(1, 10)};
        const MadeLinkage made = four_bar_linkage(m, draw(-5, 5), draw(-5, 5));
        const double angle = draw(0, 6.28);
        for (const int side : {1, -1}) {
            const auto p = pose(m, angle, side > 0 ? Assembly::open : Assembly::crossed);
            const Placed<double> placed(made, {angle}, {static_cast<std::int8_t>(side)});
            ASSERT_EQ(placed.closed, p.assembled());
            if (!p.assembled() || std::min(p.margins.stretch, p.margins.fold) < 1e-3) continue;
            ++compared;
            EXPECT_NEAR(cross(placed.pose.links[2].along, p.coupler), 0, 1e-12);
            EXPECT_NEAR(dot(placed.pose.links[2].along, p.coupler), 1, 1e-12);
            EXPECT_NEAR(cross(placed.pose.links[3].along, p.rocker), 0, 1e-12);
            EXPECT_NEAR(placed.pose.margins[0].outer, p.margins.stretch, 1e-13);
            EXPECT_NEAR(placed.pose.margins[0].inner, p.margins.fold, 1e-13);
        }
    }
    EXPECT_GT(compared, 200);
}

TEST(LinkagePlace, IsTheSliderCranksPose) {
    Draw draw{std::mt19937_64(2)};
    for (int i = 0; i < 200; ++i) {
        const SliderCrank<double> m{draw(1, 3), draw(5, 9), draw(-1, 1)};
        const MadeLinkage made = slider_crank_linkage(m);
        const double angle = draw(0, 6.28);
        const auto p = pose(m, angle);
        const Placed<double> placed(made, {angle}, {1});
        ASSERT_TRUE(placed.closed);
        EXPECT_EQ(placed.order.groups.back().kind, Group::Kind::rrp);
        EXPECT_NEAR(placed["C"].x, p.position, 1e-12);
        EXPECT_NEAR(placed["C"].y, m.offset, 1e-12);
        EXPECT_NEAR(placed.pose.links[3].origin.x, p.position, 1e-12);
        EXPECT_NEAR(placed.pose.margins[0].outer, p.left, 1e-12);
        EXPECT_NEAR(placed.pose.margins[0].inner, p.right, 1e-12);
        EXPECT_NEAR(direction(placed.pose.links[2].along), direction(p.rod), 1e-12);
    }
}

TEST(LinkagePlace, IsTheSlottedDrivesPose) {
    Draw draw{std::mt19937_64(3)};
    for (int i = 0; i < 200; ++i) {
        const double centre = draw(3, 4), angle = draw(0, 6.28);
        const Whitworth<double> w{centre, draw(5, 6), draw(1, 2), draw(6, 8), draw(0, 3)};
        MadeLinkage made;
        made.points(0, {{"O", 0, 0}, {"M", centre, 0}});
        made.drive(made.link({{"M", 0, 0}, {"B", w.crank, 0}}));
        made.link({{"O", 0, 0}, {"R", -w.arm, 0}});
        made.slot("B", made.line(2, 0, 0, 0));
        made.link({{"R", 0, 0}, {"S", w.rod, 0}});
        made.slot("S", made.line(0, 0, 0, w.slide_angle));
        const auto p = pose(w, half_turn(angle));
        const Placed<double> placed(made, {angle}, {1, 1});
        ASSERT_TRUE(placed.closed);
        EXPECT_EQ(placed.order.groups[1].kind, Group::Kind::rpr);
        EXPECT_EQ(placed.order.groups[2].kind, Group::Kind::rrp);
        EXPECT_NEAR(std::hypot(placed["S"].x, placed["S"].y), std::abs(p.output.position), 1e-12);
        EXPECT_NEAR(dot(placed["S"], {std::cos(w.slide_angle), std::sin(w.slide_angle)}), p.output.position, 1e-12);
    }
}

TEST(LinkagePlace, IsTheCrankShapersPose) {
    Draw draw{std::mt19937_64(4)};
    for (int i = 0; i < 200; ++i) {
        const CrankShaper<double> m{draw(8, 9), draw(2, 3), draw(15, 16), draw(5, 6), draw(14, 15)};
        const double angle = draw(0, 6.28);
        // Its x axis is the line of centres, from lever pivot to crank pivot.
        MadeLinkage made;
        made.points(0, {{"O", 0, 0}, {"M", m.centre_distance, 0}});
        made.drive(made.link({{"M", 0, 0}, {"B", m.crank, 0}}));
        made.link({{"O", 0, 0}, {"R", m.lever, 0}});
        const std::size_t block = made.link({{"B", 0, 0}});
        made.slide(block, made.line(2, 0, 0, 0));
        made.link({{"R", 0, 0}, {"S", m.rod, 0}});
        made.slide(made.link({{"S", 0, 0}}), made.line(0, m.ram_distance, 0, std::numbers::pi / 2));
        const Placed<double> placed(made, {angle}, {1, 1});
        ASSERT_TRUE(placed.closed);
        EXPECT_EQ(placed.order.groups[1].links, (std::vector<std::size_t>{2, 3}));
        const auto lever = placed.pose.links[2].along;
        // Straight from the figure: the lever points at the crank pin.
        EXPECT_NEAR(direction(lever),
                    std::atan2(m.crank * std::sin(angle), m.centre_distance + m.crank * std::cos(angle)), 1e-12);
        EXPECT_NEAR(placed["S"].x, m.ram_distance, 1e-12);
        EXPECT_NEAR(std::hypot(placed["S"].x - m.lever * lever.x, placed["S"].y - m.lever * lever.y), m.rod, 1e-12);
        const auto exact = places_by_newton(made, {angle}, placed.pose);
        EXPECT_LT(error_of(placed.pose, exact, 15), 1e-12);
    }
}

/// Six-bars of all five kinds, with random dimensions. Links: crank 1, then as the kind says.
MadeLinkage random_six_bar(int kind, Draw& draw) {
    MadeLinkage m;
    const auto about = [&](double size) { return draw(-size, size); };
    m.points(0, {{"A", 0, 0}, {"D", draw(3, 5), about(1)}});
    m.drive(m.link({{"A", 0, 0}, {"B", draw(0.8, 1.2), 0}}));
    m.link({{"B", 0, 0}, {"C", draw(3, 4), 0}});
    m.link({{"D", 0, 0}, {"C", draw(2.5, 3.5), about(1)}});
    const auto dyad = [&](const char* p, const char* q) {
        m.link({{p, 0, 0}, {"H", draw(3, 5), 0}, {"R", about(2), about(2)}});
        m.link({{q, 0, 0}, {"H", draw(3, 5), about(1)}});
    };
    if (kind == 0) {  // Watt I: on coupler and rocker
        m.points(2, {{"P", draw(2, 4), about(2)}});
        m.points(3, {{"Q", draw(2, 4), about(2)}});
        dyad("P", "Q");
    } else if (kind == 1) {  // Watt II: on rocker and frame
        m.points(3, {{"P", draw(2, 3), about(2)}});
        m.points(0, {{"G", draw(6, 8), about(2)}});
        dyad("P", "G");
    } else if (kind == 2) {  // Stephenson I: on crank and rocker
        m.points(1, {{"P", about(1), about(1)}});
        m.points(3, {{"Q", draw(2, 4), about(2)}});
        dyad("P", "Q");
    } else {  // Stephenson III: on coupler and frame; kind 4 with slides in place of the dyad's last pin
        m.points(2, {{"P", draw(1, 2), about(2)}});
        if (kind == 3) {
            m.points(0, {{"G", draw(5, 7), about(3)}});
            dyad("P", "G");
        } else {
            m.link({{"P", 0, 0}, {"H", draw(4, 6), 0}});
            m.slide(m.link({{"H", about(1), about(1)}}), m.line(0, about(2), about(2), about(3)), about(3), about(1));
        }
    }
    return m;
}

TEST(LinkagePlace, IsWhatNewtonFindsInFiftyDigits) {
    Draw draw{std::mt19937_64(5)};
    for (int kind = 0; kind < 5; ++kind) {
        int compared = 0;
        for (int i = 0; i < 60 && compared < 12; ++i) {
            const MadeLinkage made = random_six_bar(kind, draw);
            const double angle = draw(0, 6.28);
            const std::vector<std::int8_t> sides{static_cast<std::int8_t>(draw(0, 1) < 0.5 ? 1 : -1),
                                                 static_cast<std::int8_t>(draw(0, 1) < 0.5 ? 1 : -1)};
            const Placed<double> placed(made, {angle}, sides);
            ASSERT_TRUE(placed.order.closed());
            if (!placed.closed) continue;
            ++compared;
            // Near a toggle the pose itself depends on the dimensions by the inverse root of the margin.
            double least = 1;
            for (const auto& margin : placed.pose.margins)
                least = std::min({least, margin.outer, margin.inner});
            const auto exact = places_by_newton(made, {angle}, placed.pose);
            EXPECT_LT(error_of(placed.pose, exact, 5), 2e-14 / least) << "kind " << kind << ", case " << i;
        }
        EXPECT_GE(compared, 8) << kind;
    }
}

TEST(LinkagePlace, DrivesASlideAndARack) {
    MadeLinkage m;  // a ram on the x axis pushes a rod to a rocker; its rack turns a wheel
    m.points(0, {{"D", 5, 0}, {"W", 0, 1}});
    const std::size_t ram = m.link({{"S", 0, 0}});
    const std::size_t slide = m.slide(ram, m.line(0, 0, 0, 0));
    m.drive_slide(slide);
    m.link({{"S", 0, 0}, {"C", 3, 0}});
    m.link({{"D", 0, 0}, {"C", 3, 0}});
    const std::size_t wheel = m.link({{"W", 0, 0}});
    const linkage::Number radius = m.number(-1);
    m.s.racks.push_back({slide, wheel, 0, radius, m.number(0)});
    const Placed<double> placed(m, {1.}, {1});
    ASSERT_TRUE(placed.closed);
    EXPECT_NEAR(placed["C"].x, 3, 1e-15);
    EXPECT_NEAR(placed["C"].y, std::sqrt(5.), 1e-15);
    EXPECT_NEAR(placed.pose.turns[wheel], -1, 1e-15);
}

TEST(LinkagePlace, SaysByHowMuchItDoesNotClose) {
    const MadeLinkage made = four_bar_linkage({10, 2, 3, 4}, 0, 0);
    const Placed<double> placed(made, {std::numbers::pi}, {1});
    EXPECT_FALSE(placed.closed);
    EXPECT_DOUBLE_EQ(placed.pose.margins[0].outer, -5);
}

}  // namespace
}  // namespace mechwright::test
