#pragma once
/// \file
/// Where dyads come to their limits inside a motion and go on, as links that fold onto each other at a change point do,
/// or a slot that passes through its own pivot: what is measured, or a derivative of it, may jump there.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "analysis/linkage/measuring/course.h"
#include "analysis/numbers/golden_section.h"

namespace mechwright::linkage {

namespace detail {

/// The least margin of all dyads that close by lengths; not a number where one before does not close.
inline double least_margin(Driven<double>& driven, const Course& course, double at) {
    if (!driven.place(at, course.turns.near(at))) return std::numeric_limits<double>::quiet_NaN();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < driven.order.margins_of_dyads(); ++i)
        if (is_length(driven.order, i))
            least = std::min({least, driven.pose.margins[i].outer, driven.pose.margins[i].inner});
    return least;
}

}  // namespace detail

/// The inputs along a motion at which a dyad is at its limit, to rounding, and closes again on both sides.
inline std::vector<double> singular_inputs(const Driven<double>& driven, const Course& course) {
    constexpr int halvings = 80;
    constexpr double rounding = 1e-12;  // of the size
    constexpr double may_touch = 0.6;   // of the changes on both sides: what touches 0 between two samples has less
    const double from = course.travel.from, way = course.travel.to - from, size = size_of(driven);
    Driven<double> moving = driven;
    moving.shortfall = rounding * size;
    const auto margin_at = [&](double at) { return detail::least_margin(moving, course, at); };
    const auto shortfall_at = [&](double at) { return -margin_at(at); };
    const auto samples = static_cast<int>(18 * detail::first_panels({from, course.travel.to}));
    std::vector<double> margin;
    for (int i = 0; i <= samples + 1; ++i)
        margin.push_back(margin_at(from + (i - 0.5) * way / samples));
    std::vector<double> found;
    for (int i = 1; i <= samples; ++i) {
        const double changes = std::abs(margin[i + 1] - margin[i]) + std::abs(margin[i] - margin[i - 1]);
        if (!(margin[i] <= may_touch * changes)) continue;
        const double at =
            greatest_between(shortfall_at, from + (i - 1) * way / samples, from + i * way / samples, halvings);
        if (margin_at(at) <= rounding * size) found.push_back(at);
    }
    return found;
}

/// Whether what is asked, or a derivative of lower order, jumps at such an input in [from, to]. At the ends of a motion
/// that is not whole there is nothing to jump to.
template <std::size_t K>
bool jumps_between(Measured<double, K>& measured, const Asked& asked, const Driven<double>& driven,
                   const Course& course, double from, double to) {
    constexpr double beside = 1e-4, much = 1e-3;  // of the input's unit, of the values
    const double step = beside * measured.unit_of_input();
    const Travel& travel = course.travel;
    const double beyond = travel.whole ? detail::beyond_cycle : 0;
    const auto jumps_at = [&](double at) {
        const auto value = [&](int steps) {
            const double there = at + steps * step;
            return measured.value(asked.signal, there, course.turns.near(there));
        };
        const auto far_before = value(-3), before = value(-1), after = value(1), far_after = value(3);
        for (std::size_t k = 0; k <= std::min(asked.derivative, K); ++k) {
            const double along = std::abs(before.c[k] - far_before.c[k]) + std::abs(far_after.c[k] - after.c[k]);
            const double sizes = std::abs(before.c[k]) + std::abs(after.c[k]);
            if (std::abs(after.c[k] - before.c[k]) > 4 * along + much * sizes) return true;
        }
        return false;
    };
    for (const double input : singular_inputs(driven, course))
        for (const double at : {input, input + course.period()}) {
            const bool between = at > from - step && at < to + step;
            const bool inside = at - 3 * step > travel.from && at + 3 * step < travel.to + beyond;
            if (between && inside && (travel.whole || at == input) && jumps_at(at)) return true;
        }
    return false;
}

}  // namespace mechwright::linkage
