#pragma once
/// \file
/// Means of signals of a linkage, and of their squares, over stretches of its motion, as functions of the dimensions.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "analysis/linkage/moving_extremes.h"
#include "analysis/numbers/resolved.h"

namespace mechwright::linkage {

/// The mean of what is asked over [from, to], or of its square, as a function of the dimensions; ends that are limits
/// of the motion move with them. To rounding; of speeds over motions that end at limits, where they grow beyond all
/// bounds, to ten digits. Infinite where what is asked has no integral because of how it grows at a
/// limit.
template <class T, std::size_t K, std::size_t L>
T mean_of(Measured<T, K>& measured, Measured<double, L>& plain, const Asked& asked, const Course& course, double from,
          double to, bool squared, const MovingEnds<T>& ends = {}) {
    const Stretch stretch = detail::stretch_of(course, from, to);
    const auto end = [&](bool last) -> Extreme {
        const Travel& all = course.travel;
        const bool limit = last ? to == all.to : from == all.from;
        return {last ? to : from, 0, false, !limit ? Limit{} : last ? all.last : all.first};
    };
    // Speeds grow like the inverse root of the way from a limit, accelerations like its third power.
    const std::size_t grows = (asked.derivative + order_of(plain.signals(), asked.signal)) * (squared ? 2 : 1);
    for (const bool last : {false, true}) {
        if (grows < 2 || !(last ? stretch.root_at_to : stretch.root_at_from)) continue;
        const double at_limit = value_at_limit(plain, asked, course, last);
        if (std::isinf(at_limit)) return T(squared ? std::abs(at_limit) : at_limit);
    }
    const T shift_from = shift_of(measured, asked, course, end(false), ends),
            shift_to = shift_of(measured, asked, course, end(true), ends);
    if (asked.derivative > 0 && !squared) {
        // The integral of a derivative is known.
        const Asked integral{asked.signal, asked.derivative - 1};
        const T length = (T(to) + shift_to * T(measured.rate())) - (T(from) + shift_from * T(measured.rate()));
        return T(measured.rate()) *
               (value_at(measured, integral, course, end(true), ends) -
                value_at(measured, integral, course, end(false), ends)) /
               length;
    }
    // The rounding of the input counts as much as that of the value.
    const double floor = detail::rounding_of(
        [&](double at) { return plain.value(asked.signal, at, course.turns.near(at)); },
        std::min(asked.derivative + 1, L), detail::size_of_inputs(plain, asked.signal), plain.rate(), stretch);
    const auto f = [&](double s) {
        const double at = stretch.at(s);
        const double value = plain.value(asked.signal, at, course.turns.near(at)).derivative(asked.derivative);
        return (squared ? value * value : value) * stretch.speed(s) / stretch.length();
    };
    // So close to a limit that the rounding of the input is much of the way from it, a speed that grows there is noise.
    constexpr double noisy = 0x1p-8;
    const bool rough = grows > 0 && (stretch.root_at_from || stretch.root_at_to);
    const Panels panels(f, 0, 1,
                        {.first = detail::first_panels(stretch),
                         .within = rough ? 1e-11 : 1e-13,
                         .floor = squared ? floor * (floor / detail::one_rounding) : floor,
                         .narrowest_first = rough && stretch.root_at_from ? noisy : 0,
                         .narrowest_last = rough && stretch.root_at_to ? noisy : 0,
                         .most = 512,
                         .everywhere = true});
    if (!panels.finite()) return T(std::numeric_limits<double>::quiet_NaN());
    if constexpr (std::is_same_v<T, double>) return panels.integral();
    T sum(0);
    for (const Panel& panel : panels.all())
        for (std::size_t i = 0; i < Panel::nodes; ++i) {
            const double s = panel.at(i), at = stretch.at(s), share = (at - from) / stretch.length();
            const T shift = T(1 - share) * shift_from + T(share) * shift_to;
            const T value =
                detail::after_shift(measured.value(asked.signal, at, course.turns.near(at)), asked.derivative, shift);
            sum = sum + T(panel.weight(i) * stretch.speed(s) / stretch.length()) * (squared ? T(value * value) : value);
        }
    return sum;
}

}  // namespace mechwright::linkage
