#pragma once
/// \file
/// The working part of a quick return: the middle share of the slow stroke, by the position of the ram.

#include "analysis/numbers/extremes.h"
#include "analysis/quick_return/ram.h"

namespace mechwright {

/// Crank angles, turning counter-clockwise.
template <class T>
struct WorkingPart {
    T from;
    T to;
    bool outward;  ///< the ram moves out on it; the slow stroke is the outward one
};

namespace detail {

/// The two crank angles near those of `near` at which the ram is `inset` away from its limits, as functions of the
/// dimensions: each Newton step from the place known in double doubles the order of its derivatives, so that two make
/// it right to the second.
template <template <class> class Drive, class T>
WorkingPart<T> refined(const Drive<T>& m, const WorkingPart<double>& near, const T& inset) {
    const RamLimits<T> limits = ram_limits(m);
    const T outer = limits.outer.position - inset;
    const T inner = limits.inner.position + inset;
    const auto crank_angle = [&](double at, const T& position) {
        T x(at);
        for (int step = 0; step < 2; ++step)
            x -= (ram_position(m, x) - position) / ram_velocity(m, x);
        return x;
    };
    return {crank_angle(near.from, near.outward ? inner : outer), crank_angle(near.to, near.outward ? outer : inner),
            near.outward};
}

}  // namespace detail

/// The middle `share` (0 < share < 1) of the slow stroke. Precondition: as for strokes(m), and the strokes differ from
/// zero.
template <template <class> class Drive, class T>
WorkingPart<T> working_part(const Drive<T>& m, double share) {
    const Drive<double> plain = converted<double>(m);
    const Strokes<double> stroke_angles = strokes(plain);
    const RamLimits<double> limits = ram_limits(plain);
    const bool outward = stroke_angles.outward >= stroke_angles.inward;
    const double margin = 0.5 * (1 - share);
    const double inset = margin * stroke(plain);
    const double begin = limits.outer.crank_angle + (outward ? stroke_angles.inward : 0);
    const double end = begin + (outward ? stroke_angles.outward : stroke_angles.inward);
    const double sign = outward ? 1 : -1;
    const double first = outward ? limits.inner.position : limits.outer.position;
    const auto crank_angle = [&](double travelled) {
        const auto ahead = [&](double x) { return sign * (ram_position(plain, x) - first) - travelled; };
        return zero_between<double>(ahead, begin, end, -travelled, stroke(plain) - travelled);
    };
    const WorkingPart<double> near{crank_angle(inset), crank_angle(stroke(plain) - inset), outward};
    return detail::refined(m, near, T(margin) * stroke(m));
}

}  // namespace mechwright
