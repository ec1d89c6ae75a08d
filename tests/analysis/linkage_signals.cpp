// Signals of a linkage: their values along its motion against the geometry.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/four_bar.h"
#include "analysis/linkage/measuring/course.h"
#include "analysis/slider_crank.h"
#include "tests/analysis/known_linkages.h"
#include "tests/analysis/watched.h"

namespace mechwright::test {
namespace {

using linkage::Signal;
using Kind = linkage::Signal::Kind;

TEST(LinkageSignals, AreWhatTheirNamesSay) {
    const auto sides = sides_of(six_bar(false), {{"C", 1}, {"H", 1}});
    MadeLinkage made = six_bar(false);
    made.slide(made.link({{"H", 0, 0}}), made.line(5, 1, 0.5, 0.3), 0, 0);  // held by the output: a slide to measure
    made.s.slides.back().line.on = 5;
    const std::size_t b = made.pin("B"), p = made.pin("P"), g = made.pin("G");
    Signal turned_x = signal_of(Kind::x, p), along = signal_of(Kind::along, p), on_link = signal_of(Kind::y, p);
    along.number = 0.7;
    on_link.on = 3;
    Signal sum{Kind::sum};
    sum.terms = {{0, 2}, {1, -0.5}};
    Watched w(made,
              {angle_of(3), angle_of(5, 2, -7), turned_x, along, on_link, signal_of(Kind::distance, b, g),
               signal_of(Kind::from_line, p, b, g), signal_of(Kind::slide, 0), signal_of(Kind::speed, p),
               signal_of(Kind::acceleration, p), sum, signal_of(Kind::ratio, 5, 6)},
              sides);
    ASSERT_TRUE(w.course.travel.whole);
    w.placing = {{10, -3}, 0.4, 2};
    w.rate = 3;
    auto measured = w.measured<4>();
    const double at = 1.1, h = 1e-4;
    const auto value = [&](std::size_t signal, double x = 1.1) {
        return measured.value(signal, x, w.course.turns.near(x)).c[0];
    };
    ASSERT_TRUE(w.driven.place(at));
    const auto& pose = w.driven.pose;
    const Vector<double> P = pose.pins[p], B = pose.pins[b], G = pose.pins[g];
    const auto direction = [](const Vector<double>& v) { return std::atan2(v.y, v.x); };
    EXPECT_NEAR(value(0), direction(pose.links[3].along), 1e-14);
    EXPECT_NEAR(std::remainder(value(1) - direction(pose.links[5].along) + direction(pose.links[2].along),
                               2 * std::numbers::pi),
                0, 1e-14);
    EXPECT_NEAR(value(1, 0), -7, std::numbers::pi);
    const Vector<double> drawn{10 + 2 * (P.x * std::cos(0.4) - P.y * std::sin(0.4)),
                               -3 + 2 * (P.x * std::sin(0.4) + P.y * std::cos(0.4))};
    EXPECT_NEAR(value(2), drawn.x, 1e-14);
    EXPECT_NEAR(value(3), drawn.x * std::cos(0.7) + drawn.y * std::sin(0.7), 1e-14);
    const auto& rocker = pose.links[3];
    EXPECT_NEAR(value(4), 2 * cross(rocker.along, P - rocker.origin), 1e-14);
    EXPECT_NEAR(value(5), 2 * std::hypot(B.x - G.x, B.y - G.y), 1e-14);
    EXPECT_NEAR(value(6), 2 * cross(G - B, P - B) / std::hypot(B.x - G.x, B.y - G.y), 1e-14);
    const double slide_angle = direction(pose.links[5].along) + 0.3;
    const Vector<double> foot = pose.links[6].origin - pose.links[5].at({1, 0.5});
    EXPECT_NEAR(value(7), 2 * dot(foot, {std::cos(slide_angle), std::sin(slide_angle)}), 1e-14);
    // Differences in time, of which a unit is three of the crank.
    const auto point = [&](double x) {
        EXPECT_TRUE(w.driven.place(x));
        return w.driven.pose.pins[p];
    };
    const Vector<double> ahead = point(at + h), back = point(at - h);
    EXPECT_NEAR(value(8), 2 * 3 * std::hypot(ahead.x - back.x, ahead.y - back.y) / (2 * h), 1e-6);
    EXPECT_NEAR(value(9), 2 * 9 * std::hypot(ahead.x - 2 * P.x + back.x, ahead.y - 2 * P.y + back.y) / (h * h), 1e-5);
    EXPECT_NEAR(value(10), 2 * value(0) - 0.5 * value(1), 1e-14);
    EXPECT_NEAR(value(11), value(5) / value(6), 1e-14);
    for (std::size_t signal = 0; signal < 12; ++signal)
        EXPECT_NEAR(measured.value(signal, at, w.course.turns.near(at)).derivative(1),
                    3 * (value(signal, at + h) - value(signal, at - h)) / (2 * h), 1e-5)
            << signal;
    EXPECT_EQ(linkage::order_of(w.signals, 9), 2u);
    EXPECT_EQ(linkage::order_of(w.signals, 11), 0u);
}

TEST(LinkageSignals, TransmissionAnglesAreOfEveryDyad) {
    const FourBar<double> m{4, 1, 3.5, 3};
    Watched bars(four_bar_linkage(m), {signal_of(Kind::transmission_angle, 0)});
    auto measured = bars.measured<1>();
    const SliderCrank<double> crank{2, 5, 0.7};
    Watched rod(slider_crank_linkage(crank), {signal_of(Kind::transmission_angle, 0)});
    auto on_slide = rod.measured<1>();
    MadeLinkage shaper;
    shaper.points(0, {{"O", 0, 0}, {"M", 3, 0}});
    shaper.drive(shaper.link({{"M", 0, 0}, {"B", 1, 0}}));
    shaper.link({{"O", 0, 0}});
    shaper.slot("B", shaper.line(2, 0, 0.8, 0));
    Watched lever(shaper, {signal_of(Kind::transmission_angle, 0)});
    auto passing = lever.measured<1>();
    for (const double x : {0.1, 1.0, 2.5, 4.0, 6.0}) {
        EXPECT_NEAR(measured.value(0, x, {}).c[0], transmission_angle(m, half_turn(x)), 1e-14);
        EXPECT_NEAR(on_slide.value(0, x, {}).c[0], std::numbers::pi / 2 - std::asin((0.7 - 2 * std::sin(x)) / 5),
                    1e-14);
        EXPECT_NEAR(passing.value(0, x, {}).c[0], std::acos(0.8 / std::hypot(3 + std::cos(x), std::sin(x))), 1e-14);
    }
    EXPECT_EQ(linkage::margin_of(bars.order, bars.order.groups.back()), 0u);
    EXPECT_EQ(linkage::margin_of(rod.order, rod.order.groups.back()), 0u);
    EXPECT_EQ(linkage::margin_of(lever.order, lever.order.groups.back()), 0u);
    EXPECT_EQ(linkage::margin_of(lever.order, lever.order.groups.front()), linkage::none);
    // At the ends of a limited motion a dyad is at a toggle.
    Watched limited(four_bar_linkage({5, 3, 4, 3.2}), {signal_of(Kind::transmission_angle, 0)});
    const auto places = limited.extremes(0);
    EXPECT_EQ(places.front().value, std::numbers::pi);
    EXPECT_EQ(places.back().value, std::numbers::pi);
}

}  // namespace
}  // namespace mechwright::test
