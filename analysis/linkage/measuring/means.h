#pragma once
/// \file
/// Means of signals of a linkage, and of their squares, over stretches of its motion, as functions of the dimensions.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "analysis/linkage/measuring/moving_extremes.h"
#include "analysis/numbers/resolved.h"

namespace mechwright::linkage {

namespace detail {

/// By how much the time of both ends of a part changes.
template <class T>
struct Shifts {
    T from = T(0);
    T to = T(0);
};

/// The mean over a part of a stretch over which drives are analytic.
template <class T, std::size_t K, std::size_t L>
T mean_of_part(Measured<T, K>& measured, Measured<double, L>& plain, const Asked& asked, const Course& course,
               const Stretch& stretch, bool squared, const Shifts<T>& shifts) {
    const double from = stretch.from;
    // The rounding of the input counts as much as that of the value.
    const double floor =
        rounding_of([&](double at) { return plain.value(asked.signal, at, course.turns.near(at)); },
                    std::min(asked.derivative + 1, L), size_of_inputs(plain, asked.signal), plain.rate(), stretch);
    const auto f = [&](double s) {
        const double at = stretch.at(s);
        const double value = plain.value(asked.signal, at, course.turns.near(at)).derivative(asked.derivative);
        return (squared ? value * value : value) * stretch.speed(s) / stretch.length();
    };
    // So close to a limit that the rounding of the input is much of the way from it, a speed that grows there is noise.
    constexpr double noisy = 0x1p-8;
    const bool grows = asked.derivative + order_of(plain.signals(), asked.signal) > 0;
    const bool rough = grows && (stretch.root_at_from || stretch.root_at_to);
    const Panels panels(f, 0, 1,
                        {.first = first_panels(stretch),
                         .within = rough ? 1e-11 : 1e-13,
                         .floor = squared ? floor * (floor / one_rounding) : floor,
                         .narrowest_first = rough && stretch.root_at_from ? noisy : 0,
                         .narrowest_last = rough && stretch.root_at_to ? noisy : 0,
                         .most = 512,
                         .everywhere = true,
                         .continuous = !rough});
    if (!panels.finite()) return T(std::numeric_limits<double>::quiet_NaN());
    if constexpr (std::is_same_v<T, double>) return panels.integral();
    T sum(0);
    for (const Panel& panel : panels.all())
        for (std::size_t i = 0; i < Panel::nodes; ++i) {
            const double s = panel.at(i), at = stretch.at(s), share = (at - from) / stretch.length();
            const T shift = T(1 - share) * shifts.from + T(share) * shifts.to;
            const T value =
                after_shift(measured.value(asked.signal, at, course.turns.near(at)), asked.derivative, shift);
            sum = sum + T(panel.weight(i) * stretch.speed(s) / stretch.length()) * (squared ? T(value * value) : value);
        }
    return sum;
}

/// By how much what is asked grows over neighbouring parts of a stretch, from its first end to its last, but for jumps
/// between them. What the rounding of a break's input makes where nothing jumps is none.
template <class T, std::size_t K>
T growth_over(Measured<T, K>& measured, const Asked& asked, const Course& course, std::span<const MotionPart> parts,
              const Extreme& first, const Extreme& last, const MovingEnds<T>& ends) {
    constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
    // A derivative is the same again after a cycle, exactly so and not but for the rounding of its length.
    const bool comes_back =
        course.travel.whole && asked.derivative > 0 && first.at == course.travel.from && last.at == course.travel.to;
    T growth(0);
    if (!comes_back)
        growth = value_at(measured, asked, course, last, ends) - value_at(measured, asked, course, first, ends);
    const auto beside = [&](double at, double within) {
        const WithinPiece in_piece(measured, within);
        const auto f = measured.value(asked.signal, at, course.turns.near(at));
        return std::pair(f.derivative(asked.derivative),
                         std::abs(number_as<double>(value_of(f.derivative(asked.derivative + 1)))));
    };
    const auto add_jump = [&](double at, const MotionPart& before, double again, const MotionPart& after) {
        const auto [one, slope] = beside(at, before.within);
        const auto [other, other_slope] = beside(again, after.within);
        const T jump = other - one;
        const double way = (1 + std::abs(at)) / measured.rate();
        const double rounding = roundings * (std::abs(number_as<double>(value_of(one))) + way * (slope + other_slope));
        if (std::abs(number_as<double>(value_of(jump))) > rounding) growth = growth - jump;
    };
    for (std::size_t i = 0; i + 1 < parts.size(); ++i)
        add_jump(parts[i].stretch.to, parts[i], parts[i].stretch.to, parts[i + 1]);
    if (comes_back && parts.size() > 1) add_jump(last.at, parts.back(), first.at, parts.front());
    return growth;
}

}  // namespace detail

/// The mean of what is asked over [from, to], or of its square, as a function of the dimensions; ends that are limits
/// of the motion move with them. To rounding; of speeds over motions that end at limits, where they grow beyond all
/// bounds, to ten digits. Infinite where what is asked has no integral because of how it grows at a
/// limit. Where a drive's motion jumps it is the mean of what is between the jumps.
template <class T, std::size_t K, std::size_t L>
T mean_of(Measured<T, K>& measured, Measured<double, L>& plain, const Asked& asked, const Course& course, double from,
          double to, bool squared, const MovingEnds<T>& ends = {}) {
    const Stretch stretch = detail::stretch_of(course, from, to);
    const auto end = [&](double at, double within) -> Extreme {
        const Travel& all = course.travel;
        return {at, 0, false,
                at == to && to == all.to         ? all.last
                : at == from && from == all.from ? all.first
                                                 : Limit{},
                within};
    };
    // Speeds grow like the inverse root of the way from a limit, accelerations like its third power.
    const std::size_t grows = (asked.derivative + order_of(plain.signals(), asked.signal)) * (squared ? 2 : 1);
    for (const bool last : {false, true}) {
        if (grows < 2 || !(last ? stretch.root_at_to : stretch.root_at_from)) continue;
        const double at_limit = value_at_limit(plain, asked, course, last);
        if (std::isinf(at_limit)) return T(squared ? std::abs(at_limit) : at_limit);
    }
    T sum(0), way(0);
    const auto parts = parts_of(plain.driven().laws, stretch);
    // The integral of a derivative is known.
    const bool known = asked.derivative > 0 && !squared;
    const Asked integral{asked.signal, known ? asked.derivative - 1 : 0};
    for (const MotionPart& part : parts) {
        const Extreme first = end(part.stretch.from, part.within), last = end(part.stretch.to, part.within);
        const auto shift = [&](const Extreme& place) {
            return place.at == from || place.at == to ? shift_of(measured, asked, course, place, ends) : T(0);
        };
        const detail::Shifts<T> shifts{shift(first), shift(last)};
        const T length =
            (T(last.at) + shifts.to * T(measured.rate())) - (T(first.at) + shifts.from * T(measured.rate()));
        way = way + length;
        if (known) continue;
        const WithinPiece in_part(measured, part.within);
        const WithinPiece in_plain(plain, part.within);
        const T mean = detail::mean_of_part(measured, plain, asked, course, part.stretch, squared, shifts);
        if (parts.size() == 1) return mean;
        sum = sum + length * mean;
    }
    if (known)
        sum = T(measured.rate()) * detail::growth_over(measured, integral, course, std::span(parts),
                                                       end(from, parts.front().within), end(to, parts.back().within),
                                                       ends);
    return sum / way;
}

}  // namespace mechwright::linkage
