// The places at which margins of dyads are least: a dyad between the frame and the crank has them in closed form, and
// every dyad has none that a dense scan of its motion finds lower.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/linkage/measuring/margins.h"
#include "tests/analysis/known_linkages.h"
#include "tests/analysis/random_linkage.h"
#include "tests/analysis/watched.h"

namespace mechwright::test {
namespace {

constexpr double turn_of_margins = 2 * std::numbers::pi;

/// The least of both margins of the first dyad among places, which have them, and at many inputs of a travel.
void expect_least_margins(Watched& w, const linkage::Travel& travel) {
    auto measured = w.measured<2>();
    const auto places = linkage::margin_places(measured, w.driven, travel);
    linkage::Driven<double> scanned = w.driven;
    scanned.shortfall = std::numeric_limits<double>::infinity();
    const double size = size_of(w.driven);
    for (const bool inner : {false, true}) {
        double least = std::numeric_limits<double>::infinity(), seen = least;
        for (const linkage::MarginPlace& place : places)
            if (place.margin.margin == 0 && place.margin.inner == inner) {
                least = std::min(least, place.place.value);
                EXPECT_GE(place.place.at, travel.from);
                EXPECT_LE(place.place.at, travel.to);
                scanned.place(place.place.at, {}, 0);
                const auto& there = scanned.pose.margins[0];
                EXPECT_NEAR(place.place.value, inner ? there.inner : there.outer, 1e-13 * size);
            }
        for (int i = 0; i <= 2000; ++i) {
            scanned.place(travel.from + (travel.to - travel.from) * i / 2000, {}, 0);
            const auto& margin = scanned.pose.margins[0];
            seen = std::min(seen, inner ? margin.inner : margin.outer);
        }
        EXPECT_LE(least, seen + 1e-13 * size);
    }
}

TEST(LinkageMargins, OfADyadOnCrankAndFrameAreLeastInLine) {
    RandomLinkage draw(31);
    for (int i = 0; i < 200; ++i) {
        const FourBar<double> m{draw.number(1, 10), draw.number(1, 10), draw.number(1, 10), draw.number(1, 10)};
        const double ratio = draw.number(-3, 3), phase = draw.number(-3, 3);
        Watched w(four_bar_linkage(m), {}, {}, {{ratio, phase}});
        ASSERT_TRUE(step_of(w.order, 0).round.exists());
        const double from = draw.number(-4, 4), to = from + draw.number(0.1, 6);
        expect_least_margins(w, {from, to, false});
        Watched whole(four_bar_linkage(m), {});
        expect_least_margins(whole, {from, from + turn_of_margins, true});
        // In line the distance of crank pin and rocker pivot is the sum or the difference of ground and crank.
        auto measured = whole.measured<2>();
        const double total = m.coupler + m.rocker, difference = std::abs(m.coupler - m.rocker);
        for (const linkage::MarginPlace& place :
             linkage::margin_places(measured, whole.driven, {from, from + turn_of_margins, true})) {
            const double distance = place.margin.inner ? std::abs(m.ground - m.crank) : m.ground + m.crank;
            EXPECT_NEAR(place.place.value, place.margin.inner ? distance - difference : total - distance, 1e-13);
        }
    }
}

TEST(LinkageMargins, OfOtherDyadsAreNotTakenForThese) {
    const MadeLinkage six = six_bar(true);
    const linkage::Order order = linkage::order_of(six.s);
    EXPECT_TRUE(step_of(order, 0).round.exists());
    EXPECT_FALSE(step_of(order, 1).round.exists());
    const MadeLinkage slider = slider_crank_linkage({1, 3, 0.2});
    const linkage::Order of_slider = linkage::order_of(slider.s);
    EXPECT_FALSE(step_of(of_slider, 0).round.exists());
}

}  // namespace
}  // namespace mechwright::test
