#pragma once
/// \file
/// Signals along the motion of a linkage: all their extremes and those of their derivatives.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

#include "analysis/linkage/measuring/at_limit.h"
#include "analysis/linkage/measuring/corners.h"
#include "analysis/linkage/measuring/measured.h"
#include "analysis/linkage/measuring/signals.h"
#include "analysis/linkage/measuring/stationary_inputs.h"
#include "analysis/linkage/motion/motion_breaks.h"
#include "analysis/linkage/motion/travel.h"

namespace mechwright::linkage {

/// Where something can be extreme along a motion.
struct Extreme {
    double at = 0;
    double value = 0;
    bool stationary = true;     ///< else it is an end of the motion, or of the stretch that was asked for
    Limit limit{};              ///< an end that moves with the dimensions
    double within = by_itself;  ///< an input beside it, on the side of a rest, or of the piece of drives' motions, on
                                ///< which it has this value
};

namespace detail {

/// What is asked at the breaks of drives' motions in [from, to), where it can be extreme: where its slope changes its
/// sense, or it jumps itself; then it has two values.
template <std::size_t K>
void add_breaks(Measured<double, K>& measured, const Asked& asked, const Course& course, double from, double to,
                std::vector<Extreme>& found) {
    const std::span<const DriveLaw> laws = measured.driven().laws;
    const std::vector<double> breaks = breaks_between(laws, from, to);
    if (breaks.empty()) return;
    constexpr double turn = 2 * std::numbers::pi;
    const std::vector<double> around = breaks_between(laws, from - turn, to + turn);
    const Stretch all{from, to};
    const auto value_at = [&](double at) { return measured.value(asked.signal, at, course.turns.near(at)); };
    const double size = size_of_inputs(measured, asked.signal);
    const double floor = 4 * rounding_of(value_at, asked.derivative, size, measured.rate(), all),
                 flat = 4 * rounding_of(value_at, asked.derivative + 1, size, measured.rate(), all);
    for (const double at : breaks) {
        if (at >= to) continue;
        const auto here = std::lower_bound(around.begin(), around.end(), at);
        const auto beside = [&](double other) {
            const double within = 0.5 * (at + other);
            const WithinPiece in_piece(measured, within);
            const auto f = measured.value(asked.signal, at, course.turns.near(at));
            return std::tuple(f.derivative(asked.derivative), f.derivative(asked.derivative + 1), within);
        };
        if (here == around.begin() || here + 1 == around.end()) continue;
        const auto [before, slope_before, within_before] = beside(*(here - 1));
        const auto [after, slope_after, within_after] = beside(*(here + 1));
        const bool jumps = !(std::abs(after - before) <= floor);
        const auto sense = [&](double slope) { return slope > flat ? 1 : slope < -flat ? -1 : 0; };
        if (!jumps && sense(slope_before) == sense(slope_after) && sense(slope_before) != 0) continue;
        found.push_back({at, before, false, {}, within_before});
        if (jumps) found.push_back({at, after, false, {}, within_after});
    }
}

/// What is asked on both sides of rests, at which parts of a stretch meet.
template <std::size_t K>
void add_rests(Measured<double, K>& measured, const Asked& asked, const Course& course,
               std::span<const MotionPart> parts, std::span<const double> rests, std::vector<Extreme>& found) {
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        const double at = parts[i].stretch.to;
        if (!std::binary_search(rests.begin(), rests.end(), at)) continue;
        for (const double within : {parts[i].within, parts[i + 1].within}) {
            const WithinPiece on_side(measured, within);
            const double value = measured.value(asked.signal, at, course.turns.near(at)).derivative(asked.derivative);
            found.push_back({at, value, false, {}, within});
        }
    }
}

}  // namespace detail

/// All places in [from, to] at which what is asked can be extreme: where it is stationary, rests, and the ends. Of a
/// whole motion that is asked for whole the ends are none, unless the signal does not come back. Where the linkage does
/// not close over all of it, or something is divided by zero, one of them is not a number. K must be at least
/// `order_for` it.
template <std::size_t K>
std::vector<Extreme> extremes(Measured<double, K>& measured, const Asked& asked, const Course& course, double from,
                              double to);

/// Whether something that a signal is divided by vanishes somewhere in [from, to], to rounding. There the signal has no
/// value and beside there, where the divisor passes zero, values without bounds. K must be at least 2 more than the
/// order of the signal.
template <std::size_t K>
bool divides_by_zero(Measured<double, K>& measured, std::size_t signal, const Course& course, double from, double to) {
    constexpr double rounding = 1e-12;  // of the greatest
    const auto rests = [&](std::size_t curvature) {
        return detail::rests_between(measured, curvature, course, from, to);
    };
    return any_curvature(measured.signals(), signal, rests) ||
           any_divisor(measured.signals(), signal, [&](std::size_t divisor) {
               double least = std::numeric_limits<double>::infinity(), greatest = -least, size = 0;
               const auto see = [&](double value) {
                   least = std::min(least, value);
                   greatest = std::max(greatest, value);
                   if (std::isfinite(value)) size = std::max(size, std::abs(value));
               };
               see(measured.value(divisor, 0.5 * (from + to), course.turns.near(0.5 * (from + to))).c[0]);
               for (const Extreme& each : extremes(measured, {divisor, 0}, course, from, to))
                   see(each.value);
               return !(least > rounding * size) && !(greatest < -rounding * size);
           });
}

/// Whether something that a signal is divided by vanishes at an input, to the rounding of that.
template <std::size_t K>
bool divides_by_zero_at(Measured<double, K>& measured, std::size_t signal, const Course& course, double input) {
    constexpr double rounding = 1e-12;
    const double near = rounding * measured.unit_of_input() / std::abs(measured.rate());
    const auto rests = [&](std::size_t curvature) { return detail::rests_at(measured, curvature, course, input); };
    return any_curvature(measured.signals(), signal, rests) ||
           any_divisor(measured.signals(), signal, [&](std::size_t divisor) {
               const auto f = measured.value(divisor, input, course.turns.near(input));
               return !(std::abs(f.c[0]) > near * std::abs(f.derivative(K > 0 ? 1 : 0)));
           });
}

template <std::size_t K>
std::vector<Extreme> extremes(Measured<double, K>& measured, const Asked& asked, const Course& course, double from,
                              double to) {
    constexpr double overlap = detail::overlap_of_cycle, same_within = 1e-6;
    const Travel& travel = course.travel;
    if (divides_by_zero(measured, asked.signal, course, from, to))
        return {{from, std::numeric_limits<double>::quiet_NaN(), false}};
    const auto at = [&](double x) {
        return measured.value(asked.signal, x, course.turns.near(x)).derivative(asked.derivative);
    };
    bool by_sizes = false;
    detail::for_each_size(measured.signals(), asked, [&](std::size_t) { by_sizes = true; });
    std::vector<Extreme> found;
    bool comes_back = travel.whole && from == travel.from && to == travel.to;
    if (comes_back) {
        const double first = at(from), last = at(to);
        comes_back = std::abs(last - first) <= 1e-9 * (std::abs(first) + std::abs(last)) ||
                     std::abs(last - first) <= 1e-9 * size_of(measured.driven());
    }
    const std::span<const DriveLaw> laws = measured.driven().laws;
    if (!comes_back) {
        const Stretch stretch = detail::stretch_of(course, from, to);
        const std::vector<double> rests = detail::rests_of(measured, asked, course, stretch);
        const auto parts = parts_of(laws, stretch, rests), pieces = parts_of(laws, stretch);
        const auto end = [&](double x, const Limit& limit, bool last) {
            const bool is_limit = limit.exists() && x == (last ? travel.to : travel.from);
            // What goes by a size may have a corner at the very end: it is the value on this side of it.
            const MotionPart& part = last ? parts.back() : parts.front();
            const double within = by_sizes && std::isnan(part.within) ? part.stretch.at(0.5) : part.within;
            const WithinPiece in_piece(measured, within);
            if (!is_limit) return found.push_back({x, at(x), false, {}, within});
            found.push_back({x, value_at_limit(measured, asked, course, last), false, limit, within});
        };
        end(from, travel.first, false);
        for (const double x : detail::stationary_inputs(measured, asked, course, stretch, rests))
            if (!(x <= from) && !(x >= to)) found.push_back({x, at(x)});
        detail::add_rests(measured, asked, course, parts, rests, found);
        if (pieces.size() > 1) detail::add_breaks(measured, asked, course, pieces.front().stretch.to, to, found);
        end(to, travel.last, true);
        return found;
    }
    // One cycle and a little more, from a place where extremes seldom are; what is seen again does not count.
    const double period = course.period(), start = from + detail::seam_of_cycle;
    const Stretch stretch{start, start + period + overlap};
    const std::vector<double> rests = detail::rests_of(measured, asked, course, stretch);
    std::vector<Extreme> seen;
    for (const double x : detail::stationary_inputs(measured, asked, course, stretch, rests))
        seen.push_back({x, 0});
    detail::add_rests(measured, asked, course, parts_of(laws, stretch, rests), rests, seen);
    const auto is_known = [&](double x) {
        return std::any_of(found.begin(), found.end(),
                           [&](const Extreme& f) { return std::abs(f.at - x) < same_within; });
    };
    const auto beyond =
        std::stable_partition(seen.begin(), seen.end(), [&](const Extreme& one) { return one.at < start + period; });
    found.assign(seen.begin(), beyond);
    std::vector<Extreme> again(beyond, seen.end());
    for (Extreme& one : again) {
        one.at -= period;
        one.within -= period;
    }
    std::erase_if(again, [&](const Extreme& one) { return is_known(one.at); });
    found.insert(found.end(), again.begin(), again.end());
    for (Extreme& each : found) {
        if (each.at >= to) {
            each.at -= period;
            each.within -= period;
        }
        if (each.stationary) each.value = at(each.at);
    }
    detail::add_breaks(measured, asked, course, from, to, found);
    std::sort(found.begin(), found.end(), [](const Extreme& a, const Extreme& b) { return a.at < b.at; });
    return found;
}

}  // namespace mechwright::linkage
