// Where linkages move: against the built-in kinds' ranges, brute scans, and margins in fifty digits; cycles of gears.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/four_bar.h"
#include "analysis/linkage/motion/travel.h"
#include "analysis/quick_return.h"
#include "analysis/slider_crank.h"
#include "tests/analysis/known_linkages.h"
#include "tests/analysis/random_linkage.h"
#include "tests/degree.h"

namespace mechwright::test {
namespace {

using linkage::Driven;
using linkage::Travel;

constexpr double turn = 2 * std::numbers::pi;

struct Moving {
    MadeLinkage made;
    linkage::Order order = linkage::order_of(made.s);
    Driven<double> driven;

    Moving(MadeLinkage linkage, std::vector<std::int8_t> sides, std::vector<linkage::DriveLaw> laws = {})
        : made(std::move(linkage)),
          driven(made.s, order, std::span<const double>(made.numbers), resized(std::move(sides), order), laws) {}
    Moving(const Moving&) = delete;

    static std::vector<std::int8_t> resized(std::vector<std::int8_t> sides, const linkage::Order& order) {
        sides.resize(order.choices, 1);
        return sides;
    }
    std::vector<Travel> travels(const linkage::Inputs& inputs = {}) const { return linkage::travels(driven, inputs); }
};

/// The end that a travel has in common with a range of a built-in kind, whole turns aside.
void expect_same_angle(double a, double b, double within) { EXPECT_NEAR(std::remainder(a - b, turn), 0, within); }

TEST(LinkageTravel, IsTheFourBarsRange) {
    RandomLinkage draw(11);
    int whole = 0, limited = 0, twice = 0;
    for (int i = 0; i < 400; ++i) {
        const FourBar<double> m{draw.number(1, 10), draw.number(1, 10), draw.number(1, 10), draw.number(1, 10)};
        const CrankRange<double> range = assembled_range(m);
        const auto found = Moving(four_bar_linkage(m), {}).travels();
        if (range.full_turn) {
            ++whole;
            ASSERT_EQ(found.size(), 1u) << i;
            EXPECT_TRUE(found[0].whole);
            continue;
        }
        if (range.from > range.to) {
            EXPECT_TRUE(found.empty());
            continue;
        }
        (range.mirrored ? twice : limited)++;
        ASSERT_EQ(found.size(), range.mirrored ? 2u : 1u) << i;
        // The steepness of a margin bounds what its rounding can move.
        const double within = 2e-14 * (m.ground + m.crank + m.coupler + m.rocker) /
                              std::min({std::abs(std::sin(range.from)), std::abs(std::sin(range.to)), 1.0}) /
                              (m.ground * m.crank) * 10;
        expect_same_angle(found[0].from, range.from, within);
        expect_same_angle(found[0].to, range.to, within);
        EXPECT_NEAR(found[0].to - found[0].from, range.to - range.from, 2 * within);
        EXPECT_EQ(found[0].first.margin, 0u);
        if (!range.mirrored) continue;
        expect_same_angle(found[1].from, -range.to, within);
        expect_same_angle(found[1].to, -range.from, within);
    }
    EXPECT_GT(whole, 50);
    EXPECT_GT(limited, 50);
    EXPECT_GT(twice, 20);
}

TEST(LinkageTravel, FindsNarrowGapsAndNarrowTravels) {
    // Near change points: the gap, or what is left of a turn, is as wide as the root of the margin.
    for (const double margin : {1e-3, 1e-7, 1e-11}) {
        const auto gap = Moving(four_bar_linkage({6, 2, 4 - margin, 4}), {}).travels();
        ASSERT_EQ(gap.size(), 1u);
        const CrankRange<double> range = assembled_range(FourBar<double>{6, 2, 4 - margin, 4});
        ASSERT_FALSE(range.full_turn);
        EXPECT_NEAR(std::abs(std::remainder(gap[0].to, turn)), range.to, 1e-15 / std::sqrt(margin));
        EXPECT_NEAR(gap[0].to - gap[0].from, range.to - range.from, 2e-15 / std::sqrt(margin));
        const auto narrow = Moving(four_bar_linkage({8, 2, 3, 3 + margin}), {}).travels();
        ASSERT_EQ(narrow.size(), 1u) << margin;
        const CrankRange<double> little = assembled_range(FourBar<double>{8, 2, 3, 3 + margin});
        EXPECT_NEAR(narrow[0].to - narrow[0].from, little.to - little.from, 2e-15 / std::sqrt(margin));
    }
    // Change points themselves are passed.
    for (const FourBar<double>& m :
         {FourBar<double>{4, 2, 4, 2}, FourBar<double>{6, 2, 4, 4}, FourBar<double>{.7, .1, .3, .5}}) {
        const auto found = Moving(four_bar_linkage(m), {}).travels();
        ASSERT_EQ(found.size(), 1u);
        EXPECT_TRUE(found[0].whole);
    }
}

TEST(LinkageTravel, IsTheSliderCranksRange) {
    RandomLinkage draw(12);
    int limited = 0;
    for (int i = 0; i < 200; ++i) {
        const SliderCrank<double> m{draw.number(1, 3), draw.number(0.5, 5), draw.number(-2, 2)};
        const CrankRange<double> range = assembled_range(m);
        const auto found = Moving(slider_crank_linkage(m), {}).travels();
        if (range.full_turn) {
            ASSERT_EQ(found.size(), 1u);
            EXPECT_TRUE(found[0].whole);
            continue;
        }
        if (range.from > range.to) {
            EXPECT_TRUE(found.empty());
            continue;
        }
        ++limited;
        bool met = false;
        for (const Travel& travel : found)
            met = met || (std::abs(std::remainder(travel.from - range.from, turn)) < 1e-13 &&
                          std::abs(std::remainder(travel.to - range.to, turn)) < 1e-13);
        EXPECT_TRUE(met) << i;
    }
    EXPECT_GT(limited, 60);
}

TEST(LinkageTravel, IsWhatABruteScanFinds) {
    constexpr int samples = 20000;
    int limited = 0, several = 0, ends = 0;
    for (std::uint64_t seed = 0; seed < 160; ++seed) {
        RandomLinkage random(seed);
        random.add_crank_and_dyads(3);
        std::vector<std::int8_t> sides;
        for (int k = 0; k < 8; ++k)
            sides.push_back(random.below(2) == 0 ? 1 : -1);
        const linkage::Order order = linkage::order_of(random.made.s);
        if (!order.closed()) continue;
        sides.resize(order.choices);
        Moving moving(random.made, sides);
        const auto found = moving.travels();
        const auto in_one = [&](double x) {
            for (const Travel& travel : found)
                for (const double shifted : {x, x + turn})
                    if (travel.whole || (shifted >= travel.from && shifted <= travel.to)) return true;
            return false;
        };
        const auto near_end = [&](double x) {
            for (const Travel& travel : found)
                for (const double end : {travel.from, travel.to})
                    if (std::abs(std::remainder(x - end, turn)) < 1e-11) return true;
            return false;
        };
        int wrong = 0;
        for (int i = 0; i < samples; ++i) {
            const double x = turn * i / samples;
            if (moving.driven.place(x) != in_one(x) && !near_end(x)) ++wrong;
        }
        EXPECT_EQ(wrong, 0) << "seed " << seed;
        if (!found.empty() && !found[0].whole) ++limited;
        if (found.size() > 1) ++several;
        // In fifty digits the margin vanishes there: its value is as small as its slope times the rounding of the
        // input.
        linkage::Driven<Precise> exact(
            random.made.s, order, std::vector<Precise>(random.made.numbers.begin(), random.made.numbers.end()), sides);
        exact.shortfall = 1e-9;
        for (const Travel& travel : found)
            for (const auto& [limit, at] : {std::pair(travel.first, travel.from), std::pair(travel.last, travel.to)}) {
                if (!limit.exists() || limit.parallel) continue;
                const auto margin_at = [&](const Precise& x) {
                    exact.place(x);
                    const auto& m = exact.pose.margins[limit.margin];
                    return Precise(limit.inner ? m.inner : m.outer);
                };
                const Precise value = margin_at(Precise(at));
                const Precise slope = (margin_at(Precise(at) + Precise("1e-20")) - value) / Precise("1e-20");
                if (abs(slope) > Precise(1e4)) continue;  // behind a limit, or nearly
                EXPECT_LT(abs(value), Precise(3e-14) + abs(slope) * Precise(2e-15)) << seed;
                EXPECT_TRUE(moving.driven.place(at)) << seed;
                ++ends;
            }
    }
    EXPECT_GT(limited, 30);
    EXPECT_GT(several, 5);
    EXPECT_GT(ends, 60);
}

TEST(LinkageTravel, OfASlideDriveIsItsInterval) {
    // A rod of 5 between a driven slide and a rocker of 3 about a pivot 4 below the slide's line.
    MadeLinkage m;
    m.points(0, {{"O", 0, -4}});
    const std::size_t block = m.link({{"B", 0, 0}});
    m.drive_slide(m.slide(block, m.line(0, 0, 0, 0)));
    m.link({{"B", 0, 0}, {"C", 5, 0}});
    m.link({{"O", 0, 0}, {"C", 3, 0}});
    const auto found = Moving(m, {}).travels({-20, 20, false});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].from, -std::sqrt(48), 1e-14);
    EXPECT_NEAR(found[0].to, std::sqrt(48), 1e-14);
    const auto stopped = Moving(m, {}).travels({-20, 1, false});
    EXPECT_EQ(stopped[0].to, 1);
    EXPECT_FALSE(stopped[0].last.exists());
}

TEST(LinkageTravel, EndsWhereLinesBecomeParallel) {
    // A pin of a link that slides without turning, in a slot of the crank.
    MadeLinkage m;
    m.points(0, {{"A", 0, 0}});
    m.drive(m.link({{"A", 0, 0}}));
    const std::size_t block = m.link({{"P", 0, 0}});
    m.slide(block, m.line(0, 0, 2, 0));
    m.slot("P", m.line(1, 0, 0, 0));
    const auto found = Moving(m, {}).travels();
    ASSERT_EQ(found.size(), 2u);
    EXPECT_TRUE(found[0].first.parallel);
    EXPECT_NEAR(found[0].from, 0, 1e-15);
    EXPECT_NEAR(found[0].to, std::numbers::pi, 1e-15);
    EXPECT_NEAR(found[1].to, turn, 1e-15);
}

TEST(LinkageTravel, CyclesAreAsLongAsGearsMakeThem) {
    const auto with_wheel = [](double ratio, std::size_t first, std::size_t carrier) {
        MadeLinkage m = four_bar_linkage({4, 1, 3.5, 3});
        m.gear(first, m.link({{"A", 0, 0}, {"W", 0.5, 0}}), carrier, ratio);
        return m;
    };
    const auto turns = [](const MadeLinkage& m) {
        const Moving moving(m, {});
        return linkage::turns_of_cycle(moving.made.s, moving.driven);
    };
    EXPECT_EQ(turns(four_bar_linkage({4, 1, 3.5, 3})), 1);
    EXPECT_EQ(turns(with_wheel(-2.0, 1, 0)), 1);
    EXPECT_EQ(turns(with_wheel(-0.25, 1, 0)), 4);
    EXPECT_EQ(turns(with_wheel(21.0 / 30, 1, 0)), 10);
    EXPECT_EQ(turns(with_wheel(std::sqrt(0.5), 1, 0)), std::nullopt);
    EXPECT_EQ(turns(with_wheel(std::sqrt(0.5), 3, 0)), 1);  // of the rocker, which comes back
    // The coupler of a double crank turns back and forth, its follower once round.
    MadeLinkage m = four_bar_linkage({1, 3, 2.5, 2.8});
    m.gear(3, m.link({{"D", 0, 0}, {"W", 0.5, 0}}), 0, 1.0 / 3);
    EXPECT_EQ(turns(m), 3);
    // Two drives: the other crank at 2/3.
    MadeLinkage five;
    five.points(0, {{"A", 0, 0}, {"D", 3, 0}});
    five.drive(five.link({{"A", 0, 0}, {"B", 1, 0}}));
    five.drive(five.link({{"D", 0, 0}, {"E", 1.2, 0}}));
    five.link({{"B", 0, 0}, {"P", 2.5, 0}});
    five.link({{"E", 0, 0}, {"P", 2.8, 0}});
    const Moving moving(five, {}, {{1, 0}, {2.0 / 3, 0.5}});
    EXPECT_EQ(linkage::turns_of_cycle(moving.made.s, moving.driven), 3);
    const auto found = moving.travels({0, 3 * turn});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].whole);
}

TEST(LinkageTravel, TurnsAreContinuous) {
    // The follower of a double crank turns as often as its crank; close to a change point it does so in jerks.
    for (const double coupler : {2.5, 1.8 + 1e-6}) {
        Moving moving(four_bar_linkage({1, 3, coupler, coupler == 2.5 ? 2.8 : 2.2}), {});
        const linkage::Turns turns(moving.driven, -1, 5 * turn - 1);
        ASSERT_EQ(turns.to(), 5 * turn - 1);
        double last = turns.near(-1)[3];
        EXPECT_LE(std::abs(last), std::numbers::pi);
        EXPECT_NEAR(turns.near(5 * turn - 1)[3] - last, 5 * turn, 1e-9);
        EXPECT_NEAR(turns.near(5 * turn - 1)[1] - turns.near(-1)[1], 5 * turn, 1e-9);
        for (int i = 0; i <= 20000; ++i) {
            const double x = -1 + 5 * turn * i / 20000;
            ASSERT_TRUE(moving.driven.place(x));
            std::vector<double> now(4);
            linkage::Turns::of(moving.driven.pose, turns.near(x), now);
            if (coupler == 2.5) {
                EXPECT_LT(std::abs(now[3] - last), 0.1);
            }
            EXPECT_LT(std::abs(now[1] - x), 1e-9);
            last = now[3];
        }
    }
}

}  // namespace
}  // namespace mechwright::test
