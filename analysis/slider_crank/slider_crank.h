#pragma once
/// \file
/// The slider-crank in the frame of its slide: x along the slide, y to its left, the crank pivot at the origin.
///
/// The crank turns about the origin, its angle counted from the direction of the slide counter-clockwise; the rod joins
/// the crank pin to the ram, which moves on the line y = offset and is pushed ahead of the pin (the rod points to +x).
/// The same three parts end every quick-return drive: there the arm of the driven link takes the place of the crank.
/// All angles are radians, all lengths in one unit of the caller's choice.

#include "analysis/geometry/half_angle.h"
#include "analysis/geometry/vector.h"
#include "analysis/numbers/dual.h"
#include "analysis/numbers/scalar.h"

namespace mechwright {

template <class T>
struct SliderCrank {
    T crank;   ///< > 0
    T rod;     ///< > 0
    T offset;  ///< of the slide line from the crank pivot, positive to its left
};

template <class To, class From>
SliderCrank<To> converted(const SliderCrank<From>& m) {
    return {number_as<To>(m.crank), number_as<To>(m.rod), number_as<To>(m.offset)};
}

/// What a crank needs to turn fully: both margins >= 0. They are what is left of the rod where the crank stands square
/// to the slide.
template <class T>
struct RodMargins {
    T crank_right;  ///< rod - offset - crank: crank pointing away from a slide line on its left
    T crank_left;   ///< rod + offset - crank
};

template <class T>
RodMargins<T> rod_margins(const SliderCrank<T>& m) {
    return {sum_difference(m.rod, T(0), m.offset, m.crank), sum_difference(m.rod, m.offset, m.crank, T(0))};
}

/// Directions are unit vectors in the frame of the slide.
template <class T>
struct SliderCrankPose {
    Vector<T> crank;  ///< from crank pivot to crank pin
    Vector<T> rod;    ///< from crank pin to ram; x is the sine of the transmission angle, y that of the rod's slope
    T position;       ///< of the ram along the slide
    T left;           ///< rod less the height of the ram over the crank pin
    T right;          ///< rod plus that height

    /// Whether the rod reaches the slide. If not, it is shown square to the slide.
    bool assembled() const { return left >= T(0) && right >= T(0); }
};

namespace detail {

/// 1 + y for a unit vector, without cancellation where it points down.
template <class T>
T above_lowest(const Vector<T>& unit) {
    return unit.y < T(0) ? T(unit.x * unit.x / (T(1) - unit.y)) : T(T(1) + unit.y);
}

/// rod -+ (offset - crank y) are counted from the margins of the full turn, so that neither cancels near its zero. The
/// position crank x + rod cos is, for a crank pointing back, taken from the product of the two positions that the loop
/// allows: (rod - crank - offset)(rod + crank + offset) + 2 offset crank (1 + y), a sum of positive terms for
/// offset >= 0, and its mirror image for offset < 0.
template <class T>
SliderCrankPose<T> pose_by_formulas(const SliderCrank<T>& m, const Vector<T>& crank) {
    const RodMargins<T> margin = rod_margins(m);
    const T above = detail::above_lowest(crank);
    const T below = detail::above_lowest(-crank);
    SliderCrankPose<T> p;
    p.crank = crank;
    p.left = margin.crank_right + m.crank * above;
    p.right = margin.crank_left + m.crank * below;
    const T run = root_or_zero(T(p.left * p.right));
    const T height = m.offset - m.crank * crank.y;
    p.rod = {run / m.rod, height / m.rod};
    if (!p.assembled()) p.rod = {T(0), select(height > T(0), T(1), T(-1))};
    const T along = m.crank * crank.x;
    if (along < T(0)) {
        const T product = m.offset >= T(0)
                              ? margin.crank_right * (m.rod + m.crank + m.offset) + T(2) * m.offset * m.crank * above
                              : margin.crank_left * (m.rod + m.crank - m.offset) - T(2) * m.offset * m.crank * below;
        p.position = product / (run - along);
    } else {
        p.position = along + run;
    }
    return p;
}

}  // namespace detail

/// The pose with the crank in a direction (unit vector in the frame of the slide).
template <class T>
SliderCrankPose<T> pose(const SliderCrank<T>& m, const Vector<T>& crank) {
    return detail::pose_by_formulas(m, crank);
}

/// The same with first derivatives by the implicit function theorem, at a fraction of what the formulas cost in dual
/// numbers: of the height of the ram over the crank pin, rod w.y = offset - crank e.y, and of the loop along the slide,
/// crank e.x + rod w.x = position, with e and w the directions of crank and rod. The value has the same bits.
template <class T, std::size_t N>
SliderCrankPose<Dual<T, N>> pose(const SliderCrank<Dual<T, N>>& m, const Vector<Dual<T, N>>& crank) {
    const Vector<T> e{crank.x.value, crank.y.value};
    const SliderCrankPose<T> p = pose(SliderCrank<T>{m.crank.value, m.rod.value, m.offset.value}, e);
    // Where the rod stands square to the slide its turn is infinite.
    if (!p.assembled() || !(p.rod.x > T(0))) return detail::pose_by_formulas(m, crank);
    SliderCrankPose<Dual<T, N>> d{crank, {p.rod.x, p.rod.y}, p.position, p.left, p.right};
    const T per_rod = T(1) / m.rod.value;
    const T per_run = T(1) / p.rod.x;
    for (std::size_t i = 0; i < N; ++i) {
        const T rod = m.rod.partial[i];
        const T height = m.offset.partial[i] - (e.y * m.crank.partial[i] + m.crank.value * crank.y.partial[i]);
        const T turn = (height - p.rod.y * rod) * per_rod * per_run;
        d.rod.x.partial[i] = -p.rod.y * turn;
        d.rod.y.partial[i] = p.rod.x * turn;
        d.position.partial[i] = e.x * m.crank.partial[i] + m.crank.value * crank.x.partial[i] + p.rod.x * rod -
                                m.rod.value * p.rod.y * turn;
        d.left.partial[i] = rod - height;
        d.right.partial[i] = rod + height;
    }
    return d;
}

/// The pose at a crank angle.
template <class T>
SliderCrankPose<T> pose(const SliderCrank<T>& m, const T& crank_angle) {
    using std::cos, std::sin;
    return pose(m, Vector<T>{cos(crank_angle), sin(crank_angle)});
}

/// The transmission angle at the ram, in [0, pi/2]: a right angle less the angle between rod and slide line.
template <class T>
T transmission_angle(const SliderCrankPose<T>& p) {
    return angle(
        half_angle_of_squares(select(p.left < p.right, p.left, p.right), select(p.left < p.right, p.right, p.left)));
}

}  // namespace mechwright
