// Extremes of signals along the motion of a linkage against the built-in kinds, published numbers and brute scans,
// their means against closed forms, their derivatives against differences.

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/four_bar.h"
#include "analysis/linkage/measuring/means.h"
#include "analysis/quick_return.h"
#include "analysis/slider_crank.h"
#include "tests/analysis/known_linkages.h"
#include "tests/analysis/random_linkage.h"
#include "tests/analysis/watched.h"
#include "tests/degree.h"

namespace mechwright::test {
namespace {

using linkage::Extreme;
using linkage::Signal;
using Kind = linkage::Signal::Kind;

constexpr double one_turn = 2 * std::numbers::pi;

TEST(LinkageCourse, HasTheFourBarsExtremes) {
    RandomLinkage draw(21);
    int whole = 0, limited = 0;
    for (int i = 0; i < 200; ++i) {
        const FourBar<double> m{draw.number(1, 10), draw.number(1, 10), draw.number(1, 10), draw.number(1, 10)};
        const auto rocks = crank_rocker_margins(m), turns = double_crank_margins(m);
        const auto least = [](const auto& k) {
            return std::min({k.ground_longest, k.coupler_longest, k.rocker_longest});
        };
        if (std::max(least(rocks), least(turns)) < 1e-2) continue;
        Watched w(four_bar_linkage(m), {angle_of(3), signal_of(Kind::transmission_angle, 0)});
        ASSERT_TRUE(w.course.travel.whole);
        ++whole;
        const auto transmission = w.extremes(1);
        EXPECT_NEAR(least_of(transmission), transmission_angle(m, HalfTurn<double>{1, 0}), 1e-14);
        EXPECT_NEAR(greatest_of(transmission), transmission_angle(m, HalfTurn<double>{0, 1}), 1e-14);
        if (least(rocks) > 0) {
            const auto places = w.extremes(0);
            EXPECT_NEAR(greatest_of(places) - least_of(places), swing(m), 2e-14);
            EXPECT_EQ(places.size(), 2u);
        }
        // The velocity ratio's extremes, each of them.
        const auto ratio = w.extremes(0, 1);
        const auto exact = velocity_ratio_extremes(m, Assembly::open, {true, 0, one_turn});
        ASSERT_EQ(ratio.size(), exact.count) << i;
        for (std::size_t k = 0; k < ratio.size(); ++k) {
            const double value = velocity_ratio(m, exact.at[k], Assembly::open);
            EXPECT_NEAR(ratio[k].value, value, 1e-12 * (1 + std::abs(value))) << i;
        }
    }
    EXPECT_GT(whole, 50);
    for (int i = 0; i < 100; ++i) {
        const FourBar<double> m{draw.number(1, 10), draw.number(1, 10), draw.number(1, 10), draw.number(1, 10)};
        const CrankRange<double> range = assembled_range(m);
        if (range.full_turn || range.to - range.from < 0.1) continue;
        ++limited;
        Watched w(four_bar_linkage(m), {angle_of(3)});
        const auto speed = w.extremes(0, 1);
        EXPECT_TRUE(std::isinf(speed.front().value));
        EXPECT_TRUE(std::isinf(speed.back().value));
        EXPECT_EQ(speed.front().value, velocity_ratio_at_toggle(m, w.from(), Assembly::open)) << i;
        EXPECT_EQ(speed.back().value, velocity_ratio_at_toggle(m, w.to(), Assembly::open)) << i;
        const auto exact = velocity_ratio_extremes(m, Assembly::open, {false, w.from(), w.to()});
        EXPECT_EQ(speed.size(), exact.count) << i;
        // At a limit the rocker lies along the line from its pivot to the crank pin.
        const auto angle = w.extremes(0);
        for (const Extreme& end : {angle.front(), angle.back()}) {
            const double direction = std::atan2(m.crank * std::sin(end.at), m.crank * std::cos(end.at) - m.ground);
            EXPECT_NEAR(std::sin(end.value - direction), 0, 1e-14 * 100) << i;
        }
    }
    EXPECT_GT(limited, 20);
}

TEST(LinkageCourse, HasTheRamsExtremes) {
    RandomLinkage draw(22);
    for (int i = 0; i < 40; ++i) {
        const SliderCrank<double> m{draw.number(1, 3), draw.number(5, 9), draw.number(-1, 1)};
        Watched w(slider_crank_linkage(m), {signal_of(Kind::slide, 0)});
        const auto stroke_places = w.extremes(0);
        EXPECT_NEAR(greatest_of(stroke_places) - least_of(stroke_places), stroke(m), 1e-14);
        const double outward = std::abs(stroke_places[0].at - stroke_places[1].at);
        const Strokes<double> s = strokes(m);
        EXPECT_NEAR(std::min(std::abs(outward - s.outward), std::abs(one_turn - outward - s.outward)), 0, 1e-13);
        const CrankRange<double> range{true, 0, one_turn};
        const auto compare = [&](const auto& exact, std::size_t derivative, auto function) {
            const auto found = w.extremes(0, derivative);
            ASSERT_EQ(found.size(), exact.count) << i;
            for (std::size_t k = 0; k < found.size(); ++k)
                EXPECT_NEAR(found[k].value, function(m, exact.at[k]), 1e-13 * m.crank);
        };
        compare(ram_velocity_extremes(m, range), 1, [](const auto& d, double x) { return ram_velocity(d, x); });
        compare(ram_acceleration_extremes(m, range), 2, [](const auto& d, double x) { return ram_acceleration(d, x); });
    }
}

/// Extremes of an angle as published: crank angle and angle, degrees, in order.
void expect_extremes(const std::vector<Extreme>& found, const std::vector<std::pair<double, double>>& exact,
                     double unit) {
    ASSERT_EQ(found.size(), exact.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].at / degree, exact[i].first, 1e-10);
        EXPECT_NEAR(found[i].value / unit, exact[i].second, 1e-11);
    }
}

TEST(LinkageCourse, HasThePublishedExtremesOfSixBars) {
    // Computed in forty digits for the reference of general linkages, section 5.6.
    const auto of = [](bool watt, int first, int second) {
        const MadeLinkage made = six_bar(watt);
        Watched w(made, {angle_of(5)}, sides_of(made, {{"C", first}, {"H", second}}));
        return w.extremes(0);
    };
    expect_extremes(of(true, 1, 1),
                    {{40.804437690619, 99.635184851812},
                     {174.515169863740, 80.888301707943},
                     {228.509183144348, 81.398347429725},
                     {282.466283207642, 80.888301707943}},
                    degree);
    expect_extremes(of(true, 1, -1), {{40.804437690619, -58.006591711861}, {228.509183144348, -93.653152223839}},
                    degree);
    expect_extremes(of(true, -1, 1), {{131.490816855652, 130.549078321656}, {319.195562309381, 167.733174551749}},
                    degree);
    expect_extremes(of(false, 1, 1), {{55.136299988069, 120.416012870767}, {242.886729868593, 165.675602032824}},
                    degree);
    expect_extremes(of(false, -1, -1), {{180.871983793764, -101.167503057823}, {354.768512987868, -64.708687439680}},
                    degree);
}

TEST(LinkageCourse, HasThePublishedExtremesOfJansensFoot) {
    // Section 5.1 of the same.
    MadeLinkage made = jansen();
    const std::size_t foot = made.pin("T");
    Watched w(made, {signal_of(Kind::x, foot), signal_of(Kind::y, foot)},
              sides_of(made, {{"Y", -1}, {"W", 1}, {"U", -1}}));
    expect_extremes(w.extremes(0), {{117.15810943356067, 34.386869451451592}, {256.9383701564458, -33.521552240056649}},
                    1);
    expect_extremes(w.extremes(1),
                    {{2.3864416460195, -83.956087106231566},
                     {34.241349455172, -84.026892654443083},
                     {192.08123218914642, -61.576713158016015},
                     {329.33419447801482, -84.033886742332222}},
                    1);
}

TEST(LinkageCourse, HasThePublishedExtremesOfAGearedFiveBar) {
    // Section 5.11: the second crank is geared to the first, 2 : 1, at 30 degrees.
    MadeLinkage m;
    m.points(0, {{"A", 0, 0}, {"D", 3, 0}});
    m.drive(m.link({{"A", 0, 0}, {"B", 1, 0}}));
    m.gear(1, m.link({{"D", 0, 0}, {"E", 1.2, 0}}), 0, -2, 30 * degree);
    m.link({{"B", 0, 0}, {"P", 2.5, 0}});
    m.link({{"E", 0, 0}, {"P", 2.8, 0}});
    const std::size_t p = m.pin("P");
    Watched w(m, {signal_of(Kind::x, p), signal_of(Kind::y, p), angle_of(2)});
    expect_extremes(w.extremes(0),
                    {{43.696265729866, 3.0038861385964711},
                     {135.257026847335, 0.36695442074381412},
                     {203.856280339827, 1.4509475564890275},
                     {294.562833250181, -0.78930180793419789}},
                    1);
    const auto y = w.extremes(1);
    EXPECT_EQ(y.size(), 6u);
    EXPECT_NEAR(greatest_of(y), 3.0850862516012167, 1e-14);
    EXPECT_NEAR(least_of(y), 0.39724609805250042, 1e-14);
    // The wheel's turn is continuous: twice back in a turn.
    const auto wheel = w.extremes(2);
    EXPECT_NEAR(greatest_of(wheel) - least_of(wheel), 2 * one_turn, 1e-13);
    EXPECT_NEAR(wheel.front().value, 30 * degree, 1e-15);
}

/// The extremes that a scan of plain positions finds, polished by parabolas: values only.
std::vector<double> scanned(const std::vector<double>& values, bool whole) {
    std::vector<double> found;
    const std::size_t n = values.size();
    for (std::size_t i = whole ? 0 : 1; i + (whole ? 0 : 1) < n; ++i) {
        const double a = values[(i + n - 1) % n], b = values[i], c = values[(i + 1) % n];
        if ((b > a) != (b >= c)) continue;
        const double curvature = a - 2 * b + c;
        found.push_back(curvature == 0 ? b : b - (c - a) * (c - a) / (8 * curvature));
    }
    return found;
}

TEST(LinkageCourse, MissesNoExtremeOfRandomLinkages) {
    constexpr int samples = 2000;
    int measured_ones = 0, limited = 0, compared = 0;
    for (std::uint64_t seed = 300; seed < 400; ++seed) {
        RandomLinkage random(seed);
        random.add_crank_and_dyads(2);
        if (!linkage::order_of(random.made.s).closed()) continue;
        const std::size_t last = random.made.s.links - 1;
        Watched w(random.made, {angle_of(last), signal_of(Kind::x, random.made.s.pins.size() - 1)});
        if (!w.moves() || w.to() - w.from() < 0.5 || w.course.travel.first.parallel || w.course.travel.last.parallel)
            continue;
        ++measured_ones;
        if (!w.course.travel.whole) ++limited;
        auto m = w.measured<4>();
        for (std::size_t signal = 0; signal < 2; ++signal)
            for (std::size_t derivative = 0; derivative <= 2; ++derivative) {
                // A part of a limited motion, away from its singular ends.
                const double margin = w.course.travel.whole ? 0 : 0.01;
                const double from = w.from() + margin, to = w.to() - margin;
                std::vector<double> values;
                for (int i = 0; i < samples; ++i) {
                    const double x = from + (to - from) * i / samples;
                    values.push_back(m.value(signal, x, w.course.turns.near(x)).derivative(derivative));
                }
                const auto [low, high] = std::minmax_element(values.begin(), values.end());
                const double size = std::max(std::abs(*low), std::abs(*high));
                if (*high - *low < 1e-9) continue;  // constant
                const auto places = w.extremes(signal, derivative, from, to);
                for (const double value : scanned(values, false)) {
                    bool met = false;
                    for (const Extreme& each : places)
                        met = met || std::abs(each.value - value) < 1e-5 * size + 1e-9;
                    EXPECT_TRUE(met) << "seed " << seed << ", signal " << signal << ", derivative " << derivative;
                    ++compared;
                }
                for (const Extreme& each : places) {
                    if (!each.stationary) continue;
                    const double slope =
                        m.value(signal, each.at, w.course.turns.near(each.at)).derivative(derivative + 1);
                    const double curvature =
                        m.value(signal, each.at, w.course.turns.near(each.at)).derivative(derivative + 2);
                    EXPECT_LT(std::abs(slope), 1e-9 * size + 1e-14 * std::abs(curvature)) << seed;
                }
            }
    }
    EXPECT_GT(measured_ones, 40);
    EXPECT_GT(limited, 15);
    EXPECT_GT(compared, 300);
}

TEST(LinkageCourse, FindsExtremesOfStretchesAndCloseOnes) {
    const SliderCrank<double> m{1, 2.5, 0};
    Watched w(slider_crank_linkage(m), {signal_of(Kind::slide, 0)});
    const auto through = w.extremes(0, 0, 5, 1 + one_turn);  // through the end of the turn
    ASSERT_EQ(through.size(), 3u);
    EXPECT_NEAR(through[1].value, 3.5, 1e-15);
    EXPECT_EQ(through[0].value, ram_position(m, 5.0));
    EXPECT_FALSE(through[2].stationary);
    // The acceleration of a centric ram, cos x + sqrt(l^2 - sin^2 x), has one extreme about 180 degrees, and three
    // where its fourth derivative there, 4 / l - 1 - 3 / l^3, is positive: for rods below (3 + sqrt(21)) / 2.
    int before = 0, after = 0;
    for (const double less : {0.3, 0.03, 3e-3, 3e-4, 3e-5, 3e-6, -3e-6, -3e-5, -3e-4, -3e-3, -0.03, -0.3}) {
        Watched each(slider_crank_linkage({1, (3 + std::sqrt(21)) / 2 - less, 0}), {signal_of(Kind::slide, 0)});
        const auto found = each.extremes(0, 2, 2, 4.4);
        EXPECT_EQ(found.size(), less > 0 ? 5u : 3u) << less;
        (less > 0 ? after : before)++;
    }
    EXPECT_EQ(before, after);
}

TEST(LinkageCourse, MeansAreExactToRounding) {
    // A scotch yoke: a point's height is the sine.
    const SliderCrank<double> m{1, 2.5, 0.3};
    const MadeLinkage made = slider_crank_linkage(m);
    Watched w(made, {signal_of(Kind::y, 1), signal_of(Kind::slide, 0), angle_of(1)});
    auto measured = w.measured<4>();
    const auto mean = [&](std::size_t signal, std::size_t derivative, double from, double to, bool squared = false) {
        return linkage::mean_of(measured, measured, {signal, derivative}, w.course, from, to, squared);
    };
    EXPECT_NEAR(mean(0, 0, 0, one_turn), 0, 1e-15);
    EXPECT_NEAR(mean(0, 0, 0, one_turn, true), 0.5, 1e-15);
    EXPECT_NEAR(mean(0, 0, 1, 2), std::cos(1) - std::cos(2), 1e-15);
    EXPECT_NEAR(mean(0, 2, 1, 2, true), 0.5 - (std::sin(4) - std::sin(2)) / 4, 1e-14);
    EXPECT_NEAR(mean(1, 1, 1, 4), (ram_position(m, 4.) - ram_position(m, 1.)) / 3, 1e-15);
    EXPECT_NEAR(mean(2, 0, 0, one_turn), std::numbers::pi, 1e-14);
    EXPECT_NEAR(mean(2, 1, 0, one_turn), 1, 1e-14);
    EXPECT_NEAR(mean(2, 0, 6, 8, true), 49 + 1.0 / 3, 1e-13);
    // A rod shorter than the crank: the motion ends where it stands square. With no offset and rod = crank / 2 that is
    // 30 degrees to both sides of 180; the rod's share is the elliptic integral of sqrt(1 / 4 - sin^2), by sin u = 2
    // sin.
    Watched limited(slider_crank_linkage({1, 0.5, 0}), {signal_of(Kind::slide, 0)});
    EXPECT_NEAR(limited.to() - limited.from(), 60 * degree, 1e-14);
    auto l = limited.measured<4>();
    const double k = std::comp_ellint_1(0.5), e = std::comp_ellint_2(0.5);
    EXPECT_NEAR(linkage::mean_of(l, l, {0, 0}, limited.course, limited.from(), limited.to(), false),
                (-2 * std::sin(30 * degree) + 2 * (e - 0.75 * k)) / (60 * degree), 2e-14);
}

constexpr std::size_t chunk = 8;

TEST(LinkageCourse, DerivativesAreThoseOfDifferences) {
    using First = Dual<double, chunk>;
    using Second = SecondDual<double, chunk>;
    int limits = 0, stationary = 0, checked = 0;
    for (std::uint64_t seed = 500; seed < 560 && checked < 26; ++seed) {
        RandomLinkage random(seed);
        random.add_crank();
        random.add_dyad();
        if (seed % 2 == 0) random.add_dyad();
        if (!linkage::order_of(random.made.s).closed()) continue;
        const std::vector<Signal> signals{angle_of(random.made.s.links - 1),
                                          signal_of(Kind::x, random.made.s.pins.size() - 1)};
        const Watched w(random.made, signals);
        if (!w.moves() || w.to() - w.from() < 0.5 || w.course.travel.first.parallel || w.course.travel.last.parallel)
            continue;
        ++checked;
        // Of the last numbers, which the dyads have.
        const std::size_t n = std::min(chunk, w.made.numbers.size()), first = w.made.numbers.size() - n;
        auto plain = w.measured<4>();
        std::vector<First> numbers(w.made.numbers.begin(), w.made.numbers.end());
        std::vector<Second> twice(w.made.numbers.begin(), w.made.numbers.end());
        for (std::size_t i = 0; i < n; ++i) {
            numbers[first + i] = First::variable(w.made.numbers[first + i], i);
            twice[first + i] = Second::variable(w.made.numbers[first + i], i);
        }
        auto once = w.measured<4, First>(numbers);
        auto both = w.measured<4, Second>(twice);
        // Designs that differ a little.
        const auto changed = [&](std::size_t i, double by) {
            MadeLinkage other = w.made;
            other.numbers[first + i] += by;
            return other;
        };
        const double h = 1e-5;
        for (std::size_t signal = 0; signal < 2; ++signal) {
            const linkage::Asked asked{signal, 0};
            const auto places = w.extremes(signal);
            for (std::size_t k = 0; k < places.size(); ++k) {
                const First value = linkage::value_at(once, asked, w.course, places[k]);
                const Second second = linkage::value_at(both, asked, w.course, places[k]);
                EXPECT_NEAR(value.value, places[k].value, 1e-13 * (1 + std::abs(value.value)));
                (places[k].stationary ? stationary : limits)++;
                for (std::size_t i = 0; i < n; ++i) {
                    const Watched up(changed(i, h), signals), down(changed(i, -h), signals);
                    const auto above = up.extremes(signal), below = down.extremes(signal);
                    if (above.size() != places.size() || below.size() != places.size()) continue;
                    const double difference = (above[k].value - below[k].value) / (2 * h);
                    const double curvature = (above[k].value - 2 * places[k].value + below[k].value) / (h * h);
                    const double scale = 1 + std::abs(second.mixed(i, i));
                    EXPECT_NEAR(value.partial[i], difference, 1e-7 * scale * scale)
                        << seed << ' ' << signal << ' ' << k << ' ' << i;
                    EXPECT_NEAR(second.first[i], value.partial[i], 1e-11 * (1 + std::abs(value.partial[i])));
                    EXPECT_NEAR(second.mixed(i, i), curvature, 1e-3 * scale)
                        << seed << ' ' << signal << ' ' << k << ' ' << i;
                }
            }
            for (const bool squared : {false, true}) {
                const First value = linkage::mean_of(once, plain, asked, w.course, w.from(), w.to(), squared);
                for (std::size_t i = 0; i < n; ++i) {
                    const auto of = [&](double by) {
                        const Watched other(changed(i, by), signals);
                        auto m = other.measured<4>();
                        return linkage::mean_of(m, m, asked, other.course, other.from(), other.to(), squared);
                    };
                    EXPECT_NEAR(value.partial[i], (of(h) - of(-h)) / (2 * h),
                                1e-6 * (1 + std::abs(value.value) + std::abs(value.partial[i])))
                        << seed << ' ' << signal << ' ' << squared << ' ' << i;
                }
            }
        }
    }
    EXPECT_GT(checked, 20);
    EXPECT_GT(limits, 10);
    EXPECT_GT(stationary, 40);
}

}  // namespace
}  // namespace mechwright::test
