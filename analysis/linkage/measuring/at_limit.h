#pragma once
/// \file
/// Signals at an end of a linkage's motion where dyads are at their limits.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "analysis/linkage/measuring/corners.h"
#include "analysis/linkage/measuring/measured.h"
#include "analysis/linkage/measuring/signals.h"
#include "analysis/linkage/motion/travel.h"
#include "analysis/numbers/resolved.h"

namespace mechwright::linkage {

namespace detail {

/// Whether another dyad is at its limit, to rounding, where one has just been placed at its own: pins may meet there,
/// and what hangs on them has no place by itself.
template <class T, std::size_t K>
bool others_at_limit(const Measured<T, K>& measured, const Limit& limit) {
    constexpr double rounding = 1e-14;
    const double within = rounding * size_of(measured.driven());
    const auto& margins = measured.driven().pose.margins;
    for (std::size_t i = 0; i < measured.driven().order.margins_of_dyads(); ++i)
        for (const auto& margin : {margins[i].outer, margins[i].inner})
            if (i != limit.margin && number_as<double>(value_of(margin.c[0])) < within) return true;
    return false;
}

/// Whether the motion ends where several dyads are at their limits at once: what rounding makes of a place beside such
/// an end grows like the square of one over the root of the distance.
template <std::size_t K>
bool ends_in_several_limits(Measured<double, K>& measured, std::size_t signal, const Course& course) {
    const Travel& travel = course.travel;
    const auto at = [&](double end, const Limit& limit) {
        if (!limit.is_singular() || limit.parallel) return false;
        measured.value(signal, end, course.turns.near(end), limit);
        return others_at_limit(measured, limit);
    };
    return at(travel.from, travel.first) || at(travel.to, travel.last);
}

/// The value at 0 of the polynomial through the values of f(s) at the Chebyshev nodes of [0, width].
template <class T, class Function>
T from_nodes(const Function& f, double width) {
    const Panel panel{0, width};
    std::array<T, Panel::nodes> values;
    for (std::size_t k = 0; k < Panel::nodes; ++k)
        values[k] = f(panel.at(k));
    return Panel::at_end(values, false);
}

/// The limit of f(s) at 0 from the values beside it, where f is smooth in s and of a size. Far from 0 a polynomial
/// follows less well, near it rounding is greater: of panels that halve, the first with which the next one agrees, or
/// does best. Off by 1e-11 of the size or so: what is nearer to 0 is 0.
template <class Function>
double limit_from_beside(const Function& f, double size) {
    constexpr int halvings = 6;
    constexpr double agrees = 1e-12, off = 1e-11;  // of the size
    double width = 0.5, value = from_nodes<double>(f, width), best = value,
           apart = std::numeric_limits<double>::infinity();
    for (int i = 0; i < halvings && !(apart <= agrees * size); ++i) {
        const double nearer = from_nodes<double>(f, width /= 2);
        if (std::abs(nearer - value) < apart) {
            apart = std::abs(nearer - value);
            best = value;
        }
        value = nearer;
    }
    return std::abs(best) <= off * size ? 0 : best;
}

/// The limit of a signal at an end of the motion, from the places beside it, in the root of the distance.
template <std::size_t K>
double from_beside(Measured<double, K>& measured, std::size_t signal, const Course& course, bool last) {
    const Stretch stretch = stretch_of(course, course.travel.from, course.travel.to);
    const auto beside = [&](double s) {
        const double at = stretch.at(last ? 1 - s : s);
        return measured.value(signal, at, course.turns.near(at)).c[0];
    };
    return limit_from_beside(beside, size_of(measured.driven()));
}

}  // namespace detail

/// What is asked at an end of the motion that is a limit: derivatives are infinite there, unless the signal does not
/// depend on the dyad that ends it. Curvatures of paths whose points become infinitely fast are not known there.
template <std::size_t K>
double value_at_limit(Measured<double, K>& measured, const Asked& asked, const Course& course, bool last) {
    const Travel& travel = course.travel;
    const double end = last ? travel.to : travel.from;
    const Limit& limit = last ? travel.last : travel.first;
    const auto near = course.turns.near(end);
    if (limit.parallel) return std::numeric_limits<double>::infinity();
    if (limit.stop) return measured.value(asked.signal, end, near).derivative(asked.derivative);
    if (asked.derivative + order_of(measured.signals(), asked.signal) == 0) {
        const double value = measured.value(asked.signal, end, near, limit).c[0];
        return detail::others_at_limit(measured, limit) ? detail::from_beside(measured, asked.signal, course, last)
                                                        : value;
    }
    const Stretch stretch = detail::stretch_of(course, travel.from, travel.to);
    const auto place_beside = [&](double s) { return stretch.at(last ? 1 - s : s); };
    const auto beside = [&](double s) {
        const double at = place_beside(s);
        return measured.value(asked.signal, at, course.turns.near(at)).derivative(asked.derivative);
    };
    const auto becomes_infinite = [&](std::size_t curvature) {
        const auto speed = [&](double s) {
            const double at = place_beside(s);
            const auto v = measured.vector(curvature, at, course.turns.near(at));
            return std::hypot(v.x.c[0], v.y.c[0]);
        };
        return !(speed(0x1p-13) <= 1.5 * speed(0x1p-12));
    };
    if (any_curvature(measured.signals(), asked.signal, becomes_infinite))
        return std::numeric_limits<double>::quiet_NaN();
    // What goes like the inverse root of the distance or steeper at least doubles when that is quartered.
    const double nearer = beside(0x1p-13), farther = beside(0x1p-12);
    if (std::abs(nearer) > 1.5 * std::abs(farther))
        return std::copysign(std::numeric_limits<double>::infinity(), nearer);
    return measured.value(asked.signal, end, near).derivative(asked.derivative);
}

}  // namespace mechwright::linkage
