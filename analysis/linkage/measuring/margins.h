#pragma once
/// \file
/// How near the dyads of a linkage come to their limits along its motion: all least values of their margins.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "analysis/linkage/measuring/in_line.h"
#include "analysis/linkage/measuring/moving_extremes.h"
#include "analysis/numbers/golden_section.h"

namespace mechwright::linkage {

/// A margin at a place where it can be least.
struct MarginPlace {
    Limit margin{};
    Extreme place{};
};

namespace detail {

/// Where the distance of a dyad's outer pins passes 0, far beyond its limit, its margin has a cusp and no derivative:
/// the least of samples, and golden section about it.
template <class Function>
void add_cusp(const Function& margin_at, const Stretch& stretch, std::vector<MarginPlace>& places,
              const Limit& margin) {
    constexpr int samples = 360, halvings = 80;
    const auto value = [&](double s) { return margin_at(stretch.at(s)).c[0]; };
    int lowest = -1;
    double least = 0;
    for (int i = 0; i <= samples; ++i)
        if (const double one = value(static_cast<double>(i) / samples); one < least) {
            lowest = i;
            least = one;
        }
    if (lowest < 0) return;
    double from = std::max(lowest - 1, 0) / static_cast<double>(samples),
           to = std::min(lowest + 1, samples) / static_cast<double>(samples);
    const double golden = 0.38196601125010515;
    for (int i = 0; i < halvings; ++i) {
        const double a = from + golden * (to - from), b = to - golden * (to - from);
        if (value(a) < value(b))
            to = b;
        else
            from = a;
    }
    const double s = 0.5 * (from + to);
    places.push_back({margin, {stretch.at(s), value(s), false, {}}});
}

/// A margin at the ends of a part of a motion.
template <std::size_t K>
void add_margin_ends(Measured<double, K>& measured, const Limit& margin, const Travel& travel, const Turns& turns,
                     std::vector<MarginPlace>& places) {
    if (travel.whole) return;
    const auto parts = parts_of(measured.driven().laws, {travel.from, travel.to});
    const auto add = [&](double x, const Limit& limit, double within) {
        const WithinPiece in_part(measured, within);
        if (!limit.parallel)
            places.push_back(
                {margin, {x, measured.margin(margin, x, turns.near(x), limit).c[0], false, limit, within}});
    };
    add(travel.from, travel.first, parts.front().within);
    add(travel.to, travel.last, parts.back().within);
}

/// Where the slope of one margin vanishes along a motion both margins of its dyad are looked at, for they have the same
/// stationary places unless radii follow from inputs; `sought` are those that get places.
template <std::size_t K>
void add_margin_places(Measured<double, K>& measured, std::size_t margin, std::span<const bool> sought,
                       const Turns& turns, const Travel& travel, std::vector<MarginPlace>& places) {
    constexpr double seam_overlap = 0.125, unit = 2e-15;
    const double overlap = travel.whole ? seam_overlap : 0;
    const Stretch all{travel.from, travel.to + overlap, travel.first.is_singular(), travel.last.is_singular()};
    bool passes_limit = false;
    const auto both = [&](double x) -> const Margin<Series<double, K>>& {
        const auto& at = measured.margins(margin, x, turns.near(x));
        passes_limit = passes_limit || at.inner.c[0] < 0;
        return at;
    };
    // Where lines become parallel margins grow beyond all bounds, and their slopes like the inverse square of the way.
    const int powers = travel.first.parallel || travel.last.parallel ? 5 : 1;
    const bool by_inner = sought.front();
    const double floor = unit * size_of(measured.driven());
    std::array<std::vector<Extreme>, 2> found;
    std::array<double, 2> slope_before{};
    const auto parts = parts_of(measured.driven().laws, all);
    for (const MotionPart& part : parts) {
        const Stretch& stretch = part.stretch;
        const WithinPiece in_part(measured, part.within);
        const auto slope = [&](double s) {
            const auto& at = both(stretch.at(s));
            return (by_inner ? at.inner : at.outer).derivative(1) *
                   std::pow(stretch.speed(s) / stretch.length(), powers);
        };
        const Panels panels(slope, stretch.first(), stretch.last(),
                            {.first = first_panels(stretch, parts.size() > 1), .floor = floor});
        if (panels.greatest() > 4 * floor)
            panels.zeros(slope, [&](double s) {
                const auto& at = both(stretch.at(s));
                // Where a line passes through the pin that it turns about the margin has a cusp at 0.
                constexpr double cusp = 1e-6;  // of the size
                for (const bool inner : sought)
                    if (const auto& value = inner ? at.inner : at.outer; value.derivative(2) > 0)
                        found[inner].push_back({stretch.at(s), value.c[0]});
                    else if (std::abs(value.c[0]) < cusp * size_of(measured.driven()))
                        found[inner].push_back({stretch.at(s), value.c[0], false});
            });
        else
            for (const bool inner : sought) {
                const auto& at = both(stretch.at(0.5));
                found[inner].push_back({stretch.at(0.5), (inner ? at.inner : at.outer).c[0], false, {}});
            }
        // Between two parts they may be least, too.
        for (const bool inner : sought) {
            const auto value_at = [&](double x) {
                const auto& at = both(x);
                return inner ? at.inner : at.outer;
            };
            if (stretch.from > all.from && slope_before[inner] <= 0)
                if (const auto value = value_at(stretch.from); value.derivative(1) >= 0)
                    found[inner].push_back({stretch.from, value.c[0], false, {}, part.within});
            if (stretch.to < all.to) slope_before[inner] = value_at(stretch.to).derivative(1);
        }
    }
    for (const bool inner : sought) {
        for (const Extreme& place : found[inner])
            places.push_back({{margin, inner}, place});
        // The slope jumps at a cusp: its panels are split until one of their nodes sees what lies about it.
        if (inner && passes_limit)
            add_cusp([&](double x) -> const auto& { return both(x).inner; }, all, places, {margin, inner});
        add_margin_ends(measured, {margin, inner}, travel, turns, places);
    }
}

/// As add_margin_places for both margins of such a dyad: the distance of its outer pins is greatest and least where the
/// driven link is in line with the frame (the law of cosines).
template <std::size_t K>
void add_margins_in_line(Measured<double, K>& measured, std::size_t margin, const CarriedRound& round,
                         const Driven<double>& driven, const Travel& travel, std::vector<MarginPlace>& places) {
    Driven<double> moving = driven;
    moving.shortfall = std::numeric_limits<double>::infinity();
    moving.place(travel.from, {}, margin);
    const InLine found = in_line(round, driven.laws[round.input].ratio, travel.from, travel.to, size_of(driven),
                                 [&](std::size_t pin) { return moving.pose.pins[pin]; });
    const auto add = [&](bool inner, double at, bool stationary) {
        const auto& both = measured.margins(margin, at, {});
        places.push_back({{margin, inner}, {at, (inner ? both.inner : both.outer).c[0], stationary, {}}});
    };
    for (const InLine::Input& input : found.inputs)
        if (input.at < travel.to && (travel.whole || input.at > travel.from))
            add(!input.stretched, input.at, input.stretched || !found.pins_meet);
    if (found.constant)
        for (const bool inner : {false, true})
            add(inner, travel.from + 0.5 * (travel.to - travel.from), false);
    for (const bool inner : {false, true})
        add_margin_ends(measured, {margin, inner}, travel, Turns(), places);
}

}  // namespace detail

/// The places at which margins are least, of every dyad that has lengths for margins, over those parts of a motion in
/// which all dyads before it close; of parts the ends, too.
template <std::size_t K>
std::vector<MarginPlace> margin_places(Measured<double, K>& measured, const Driven<double>& driven,
                                       const Travel& over) {
    std::vector<MarginPlace> places;
    std::vector<Travel> now{over};
    const double size = size_of(driven);
    for (std::size_t margin = 0; margin < driven.order.margins && !now.empty(); ++margin) {
        std::vector<Travel> next;
        for (const Travel& travel : now) {
            const CarriedRound& round = step_of(driven.order, margin).round;
            if (round.exists() && !driven.laws[round.input].motion) {
                detail::add_margins_in_line(measured, margin, round, driven, travel, places);
            } else if (!is_of_lines(driven.order, margin) && step_together(driven.order, margin) == nullptr) {
                Driven<double> moving = driven;
                moving.shortfall = std::numeric_limits<double>::infinity();
                const Turns turns(moving, travel.from, travel.to + (travel.whole ? 0.125 : 0));
                constexpr std::array both{false, true};
                const auto add = [&](std::span<const bool> sought) {
                    detail::add_margin_places(measured, margin, sought, turns, travel, places);
                };
                if (!driven.order.is_stop(margin) && !step_of(driven.order, margin).is_extended())
                    add(both);
                else
                    for (const bool& inner : std::span(both).first(driven.order.is_stop(margin) ? 1 : 2))
                        add({&inner, 1});
            }
            if (margin + 1 < driven.order.margins) detail::split(driven, margin, size, travel, next);
        }
        now = std::move(next);
    }
    return places;
}

namespace detail {

/// The least sine of the angle between two lines, without its sign, over a travel in which it does not vanish.
inline double least_sine(const Driven<double>& driven, std::size_t margin, const Travel& travel) {
    constexpr int samples = 180, steps = 40;
    MarginAlong sine(driven, margin);
    sine.follow(travel.from, travel.to);
    const double step = (travel.to - travel.from) / samples;
    double place = travel.from, least = sine.least(place);
    for (int i = 1; i <= samples; ++i)
        if (const double one = sine.least(travel.from + i * step); one < least) {
            least = one;
            place = travel.from + i * step;
        }
    const double lowest =
        greatest_between([&](double x) { return -sine.least(x); }, std::max(travel.from, place - step),
                         std::min(travel.to, place + step), steps);
    return std::min(least, sine.least(lowest));
}

}  // namespace detail

/// Whether lines that hold something meet all over a motion, at an angle whose sine is no less than a ten-thousandth.
/// Where they become parallel what they hold goes beyond all bounds, and comes back from the other side.
inline bool lines_meet(const Driven<double>& driven, const Travel& over) {
    constexpr double least_sine = 1e-4;
    std::vector<Travel> now{over};
    const double size = size_of(driven);
    for (std::size_t margin = 0; margin < driven.order.margins; ++margin) {
        std::vector<Travel> next;
        for (const Travel& travel : now)
            detail::split(driven, margin, size, travel, next);
        if (is_of_lines(driven.order, margin)) {
            if (next != now) return false;
            for (const Travel& travel : now)
                if (!(detail::least_sine(driven, margin, travel) >= least_sine)) return false;
        }
        now = std::move(next);
    }
    return true;
}

/// A margin at such a place of a motion as a function of the dimensions.
template <class T, std::size_t K>
T margin_at(Measured<T, K>& measured, const MarginPlace& least, std::span<const double> near, const Travel& travel,
            const MovingEnds<T>& ends = {}) {
    const WithinPiece in_piece(measured, least.place.within);
    const auto f = measured.margin(least.margin, least.place.at, near, least.place.limit);
    if (least.place.stationary) return detail::after_shift(f, 0, detail::shift_of_zero(f, 1, measured.rate()));
    if (!least.place.limit.exists()) return detail::after_shift(f, 0, ends.at(least.place, travel));
    const T shift = detail::shift_of_zero(measured.margin(least.place.limit, least.place.at, near), 0, measured.rate());
    return detail::after_shift(f, 0, shift);
}

/// The limit that an end of a motion is, to the rounding of its input; none if it is none.
template <class T, std::size_t K>
Limit limit_at(Measured<T, K>& measured, double master, std::span<const double> near) {
    constexpr double rounding = 2e-14;
    Limit nearest;
    const Order& order = measured.driven().order;
    const double size = size_of(measured.driven());
    double least = rounding;
    for (std::size_t i = 0; i < order.margins; ++i) {
        if (const Step* step = step_together(order, i)) {
            if (const auto& way = measured.driven().groups[step->joint].way)
                for (const bool last : {false, true})
                    if ((last ? way->last : way->first).limit && way->is_at(master, (last ? way->last : way->first).at))
                        return {i, last};
            continue;
        }
        if (is_of_lines(order, i)) continue;
        const double unit = is_length(order, i) ? size : 1;
        for (const bool inner : {false, true}) {
            if (inner && order.is_stop(i)) continue;
            const double margin =
                std::abs(number_as<double>(value_of(measured.margin({i, inner}, master, near).c[0]))) / unit;
            if (!(margin <= least)) continue;
            least = margin;
            nearest = {i, inner, false, order.is_stop(i)};
        }
    }
    return nearest;
}

}  // namespace mechwright::linkage
