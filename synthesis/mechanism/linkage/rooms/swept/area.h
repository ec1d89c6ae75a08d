#pragma once
/// \file
/// The area within the outline of what a blade sweeps, as a function of the dimensions: Green's theorem, arc by arc,
/// each of which moves with its corners.

#include <cmath>
#include <cstddef>
#include <type_traits>

#include "analysis/numbers/resolved.h"
#include "synthesis/mechanism/linkage/rooms/swept/curves.h"

namespace mechwright::measuring {

/// The share of a stretch at which an input of it is.
inline double share_at(const Stretch& stretch, double input) {
    if (input <= stretch.from) return 0;
    if (input >= stretch.to) return 1;
    double low = 0, high = 1;
    for (double middle = 0.5; middle > low && middle < high; middle = 0.5 * (low + high))
        (stretch.at(middle) < input ? low : high) = middle;
    return high;
}

/// Twice the area between an arc and the origin, against the clock. `plain` are the same curves in doubles: they say
/// how many panels an arc needs.
template <class T, std::size_t K>
T twice_area_of(SweptCurves<T, K>& curves, SweptCurves<double, K>& plain, const SweptOutline& outline,
                const SweptArc& arc) {
    const SweptCurve& curve = outline.curves[arc.curve];
    const T first = curves.shift(arc.first, arc.curve), last = curves.shift(arc.last, arc.curve);
    if (curve.is_straight()) {
        const auto [start, end] = curves.ends_of(curve);
        const Vector<T> along = end - start;
        return cross(Vector<T>(start + T(T(arc.from) + first) * along), Vector<T>(start + T(T(arc.to) + last) * along));
    }
    // By the share of the whole piece, in which what grows like the root of the way from a limit is smooth.
    const Stretch& stretch = outline.pieces[curve.piece].stretch;
    const double from = share_at(stretch, arc.from), to = share_at(stretch, arc.to);
    const double rate = plain.rate();
    const auto f = [&](double s) {
        const auto at = plain.at(curve, stretch.at(s));
        return (at.x.c[0] * at.y.c[1] - at.y.c[0] * at.x.c[1]) * stretch.speed(s) / rate;
    };
    // So close to a limit that the rounding of the input is much of the way from it, a slope that grows there is noise.
    constexpr double noisy = 0x1p-7;
    const bool rough = stretch.root_at_from || stretch.root_at_to;
    const Panels panels(f, from, to,
                        {.first = 1,
                         .within = rough ? 1e-11 : 1e-13,
                         .narrowest_first = stretch.root_at_from && from < noisy ? noisy : 0,
                         .narrowest_last = stretch.root_at_to && to > 1 - noisy ? noisy : 0,
                         .most = 256,
                         .everywhere = true});
    if constexpr (std::is_same_v<T, double>) return panels.finite() ? panels.integral() : NAN;
    const T longer = T(1) + (last - first) * T(rate / (arc.to - arc.from));
    T sum(0);
    for (const Panel& panel : panels.all())
        for (std::size_t i = 0; i < Panel::nodes; ++i) {
            const double s = panel.at(i), input = stretch.at(s), share = (input - arc.from) / (arc.to - arc.from);
            const T shift = T(1 - share) * first + T(share) * last;
            const auto at = curves.at(curve, input);
            sum = sum + T(panel.weight(i) * stretch.speed(s) / rate) *
                            cross(curves.moved(at, 0, shift), curves.moved(at, 1, shift));
        }
    return sum * longer;
}

template <class T, std::size_t K>
T area_within(linkage::Measured<T, K>& measured, linkage::Measured<double, K>& plain_measured,
              const linkage::Course& course, const SweptOutline& outline, const linkage::MovingEnds<T>& ends) {
    SweptCurves<T, K> curves(measured, course, outline, ends);
    SweptCurves<double, K> plain(plain_measured, course, outline, {});
    T twice(0);
    for (const SweptArc& arc : outline.arcs) {
        const T one = twice_area_of(curves, plain, outline, arc);
        twice = arc.backward ? T(twice - one) : T(twice + one);
    }
    return T(0.5) * twice;
}

}  // namespace mechwright::measuring
