#pragma once
/// \file
/// Limit positions of a slider-crank whose crank turns fully: crank and rod in line. Reference: Theory of Machines,
/// section 2.4; written so that no difference of nearly equal numbers is left.

#include "analysis/slider_crank/slider_crank.h"

namespace mechwright {

/// The crank angle, turning counter-clockwise, through which the ram moves out (position grows) and back in. Their sum
/// is a full turn. Turning clockwise the two change places.
template <class T>
struct Strokes {
    T outward;
    T inward;
};

/// Where the ram turns back.
template <class T>
struct RamLimit {
    T crank_angle;
    T position;
};

template <class T>
struct RamLimits {
    RamLimit<T> outer;  ///< crank and rod in line, the rod beyond the crank
    RamLimit<T> inner;  ///< the rod laid back over the crank
};

namespace detail {

/// The positions of the ram at its limits, and their sum.
template <class T>
struct LimitRuns {
    T outer;
    T inner;
    T sum;
};

template <class T>
LimitRuns<T> limit_runs(const SliderCrank<T>& m) {
    const RodMargins<T> margin = rod_margins(m);
    const T two_cranks = T(2) * m.crank;
    const T outer = root_or_zero(T((margin.crank_right + two_cranks) * (margin.crank_left + two_cranks)));
    const T inner = root_or_zero(T(margin.crank_right * margin.crank_left));
    return {outer, inner, outer + inner};
}

}  // namespace detail

/// Precondition here and below: both rod_margins >= 0.
template <class T>
RamLimits<T> ram_limits(const SliderCrank<T>& m) {
    using std::atan2;
    const auto run = detail::limit_runs(m);
    return {{atan2(m.offset, run.outer), run.outer}, {pi<T>() + atan2(m.offset, run.inner), run.inner}};
}

/// outer - inner = (outer^2 - inner^2) / (outer + inner), and the squares differ by 4 crank rod.
template <class T>
T stroke(const SliderCrank<T>& m) {
    return T(4) * m.crank * m.rod / detail::limit_runs(m).sum;
}

/// The directions from the crank pivot to the two limits of the ram differ by the angle by which the inward stroke
/// exceeds half a turn.
template <class T>
Strokes<T> strokes(const SliderCrank<T>& m) {
    using std::atan2;
    const auto run = detail::limit_runs(m);
    const T excess = atan2(T(4) * m.offset * m.crank * m.rod / run.sum, run.outer * run.inner + m.offset * m.offset);
    return {pi<T>() - excess, pi<T>() + excess};
}

}  // namespace mechwright
