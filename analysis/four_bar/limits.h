#pragma once
/// \file
/// Limit positions of the rocker of a crank-rocker (crank and coupler in line), the swing between them, the time ratio;
/// and the range of crank angles in which a linkage assembles at all.
///
/// Derivations: at a limit the triangle A0-B0-B has the sides ground, rocker and coupler +- crank; its half angles are
/// square roots of products of Grashof margins. The swing is the difference of two angles at B0 whose cosines differ by
/// 2 crank coupler / (ground rocker); written with that difference it keeps its digits for the smallest cranks.

#include <limits>

#include "analysis/four_bar/grashof.h"
#include "analysis/four_bar/pose.h"
#include "analysis/geometry/crank_range.h"

namespace mechwright {

namespace detail {

/// The eight factors of the two limit triangles. Those that are small for a small crank exceed a margin by two cranks,
/// and are computed so: they keep their digits.
template <class T>
struct LimitTriangles {
    FullTurnMargins<T> margin;
    T without_ground;   ///< crank + coupler + rocker - ground
    T without_coupler;  ///< ground + crank + rocker - coupler
    T without_rocker;   ///< ground + crank + coupler - rocker
    T without_crank;    ///< ground + coupler + rocker - crank
    T perimeter;
};

template <class T>
LimitTriangles<T> limit_triangles(const FourBar<T>& m) {
    const auto margin = crank_rocker_margins(m);
    const T two_cranks = T(2) * m.crank;
    const T perimeter = (m.ground + m.crank) + (m.coupler + m.rocker);
    return {margin,
            margin.ground_longest + two_cranks,
            margin.coupler_longest + two_cranks,
            margin.rocker_longest + two_cranks,
            perimeter - two_cranks,
            perimeter};
}

/// At A0, from the ground link to the rocker pin, crank and coupler extended.
template <class T>
HalfAngle<T> extended_at_crank(const LimitTriangles<T>& k) {
    return {root_or_zero(T(k.margin.coupler_longest * k.without_ground)),
            root_or_zero(T(k.perimeter * k.without_rocker))};
}

/// The same with crank and coupler folded over each other.
template <class T>
HalfAngle<T> folded_at_crank(const LimitTriangles<T>& k) {
    return {root_or_zero(T(k.margin.ground_longest * k.without_coupler)),
            root_or_zero(T(k.margin.rocker_longest * k.without_crank))};
}

/// At B0, between ground link and rocker, crank and coupler extended.
template <class T>
HalfAngle<T> extended_at_rocker(const LimitTriangles<T>& k) {
    return {root_or_zero(T(k.without_ground * k.without_rocker)),
            root_or_zero(T(k.perimeter * k.margin.coupler_longest))};
}

/// The same with crank and coupler folded over each other.
template <class T>
HalfAngle<T> folded_at_rocker(const LimitTriangles<T>& k) {
    return {root_or_zero(T(k.margin.ground_longest * k.margin.rocker_longest)),
            root_or_zero(T(k.without_crank * k.without_coupler))};
}

/// At B, between coupler and rocker, crank and coupler extended: the transmission angle.
template <class T>
HalfAngle<T> extended_transmission(const LimitTriangles<T>& k) {
    return {root_or_zero(T(k.margin.coupler_longest * k.without_rocker)),
            root_or_zero(T(k.perimeter * k.without_ground))};
}

/// The same with crank and coupler folded over each other.
template <class T>
HalfAngle<T> folded_transmission(const LimitTriangles<T>& k) {
    return {root_or_zero(T(k.margin.rocker_longest * k.without_coupler)),
            root_or_zero(T(k.margin.ground_longest * k.without_crank))};
}

}  // namespace detail

/// One limit position: crank angle, angle of the rocker (both from the ground link), transmission angle; radians.
template <class T>
struct LimitPosition {
    T crank_angle;
    T rocker_angle;
    T transmission_angle;
};

template <class T>
struct LimitPositions {
    LimitPosition<T> extended;  ///< crank and coupler in one line, pin beyond crank
    LimitPosition<T> folded;    ///< coupler laid back over the crank
};

/// Limit positions of a crank-rocker. Precondition: all crank_rocker_margins >= 0.
template <class T>
LimitPositions<T> limit_positions(const FourBar<T>& m, Assembly assembly) {
    const auto k = detail::limit_triangles(m);
    const T side(side_of(assembly));
    const auto folded = detail::folded_at_crank(k);
    // At a limit the coupler lies along the line A0-B, so the transmission angle is the third angle of the triangle.
    return {{side * angle(detail::extended_at_crank(k)), side * angle(supplement(detail::extended_at_rocker(k))),
             angle(detail::extended_transmission(k))},
            {assembly == Assembly::open ? pi<T>() + angle(folded) : angle(supplement(folded)),
             side * angle(supplement(detail::folded_at_rocker(k))), angle(detail::folded_transmission(k))}};
}

/// The angle through which the rocker of a crank-rocker swings, in (0, pi). Precondition as limit_positions.
template <class T>
T swing(const FourBar<T>& m) {
    using std::atan2;
    const auto k = detail::limit_triangles(m);
    const auto e = detail::extended_at_rocker(k);
    const auto f = detail::folded_at_rocker(k);
    const T crossed = e.sine * f.cosine + e.cosine * f.sine;
    const T product = T(4) * m.ground * m.rocker;
    return T(2) * atan2(T(4) * m.crank * m.coupler / crossed, (e.cosine * f.cosine + e.sine * f.sine) / product);
}

/// How much more than half a turn the crank makes from the extended to the folded limit when an open linkage turns
/// counter-clockwise (radians, signed). The other stroke takes pi less this angle. Precondition as limit_positions.
///
/// The difference of the two angles at A0. With s, c the half angles scaled by the sides, (s_f c_e)^2 - (c_f s_e)^2 =
/// 8 ground crank (coupler^2 + rocker^2 - ground^2 - crank^2), which gives s_f c_e - c_f s_e by the sum of the two.
/// Not a number where a coupler as long as its crank lies on it for half a turn (a kite or rhombus with the rocker as
/// long as the ground link): the rocker stands still there, and no stroke begins or ends.
template <class T>
T stroke_excess(const FourBar<T>& m) {
    using std::atan2;
    const auto k = detail::limit_triangles(m);
    const auto e = detail::extended_at_crank(k);
    const auto f = detail::folded_at_crank(k);
    const T crossed = f.sine * e.cosine + f.cosine * e.sine;
    if (!(f.sine > T(0)) && !(f.cosine > T(0))) return T(std::numeric_limits<double>::quiet_NaN());
    if (!(crossed > T(0))) return T(0);  // both limits lie on the ground line
    const T squares = (m.coupler - m.ground) * (m.coupler + m.ground) + (m.rocker - m.crank) * (m.rocker + m.crank);
    return T(2) * atan2(T(8) * m.ground * m.crank * squares / crossed, f.cosine * e.cosine + f.sine * e.sine);
}

/// The crank angles at which the linkage assembles. Of two separate ranges the one above the ground line is given. An
/// open chain gives an empty range (from > to).
template <class T>
CrankRange<T> assembled_range(const FourBar<T>& m) {
    const auto at_zero = assembly_margins(m, HalfTurn<T>{T(1), T(0)});
    const auto at_pi = assembly_margins(m, HalfTurn<T>{T(0), T(1)});
    // The diagonal grows from 0 to pi: folding limits the range near 0, stretching near pi.
    if (at_zero.stretch < T(0) || at_pi.fold < T(0)) return {false, T(1), T(0)};
    const bool folds = at_zero.fold < T(0);
    const bool stretches = at_pi.stretch < T(0);
    if (!folds && !stretches) return {true, T(0), T(2) * pi<T>()};
    const T product = T(4) * m.ground * m.crank;
    // sin^2(theta/2) product = (d - |ground - crank|)(d + |ground - crank|) at the limiting diagonal d, and likewise
    // for the cosine; the small factors are the margins at 0 and pi.
    const auto limit = [&](const T& d, const T& above_zero, const T& below_pi) {
        const T sine_square = above_zero * (d + at_zero.diagonal) / product;
        const T cosine_square = below_pi * (d + at_pi.diagonal) / product;
        return angle(HalfAngle<T>{root_or_zero(sine_square), root_or_zero(cosine_square)});
    };
    using std::abs;
    const T folded = abs(m.coupler - m.rocker);
    const T stretched = m.coupler + m.rocker;
    const T from = folds ? limit(folded, -at_zero.fold, at_pi.fold) : T(0);
    const T to = stretches ? limit(stretched, at_zero.stretch, -at_pi.stretch) : pi<T>();
    if (folds && stretches) return {false, from, to, true};
    if (folds) return {false, from, T(2) * pi<T>() - from};
    return {false, -to, to};
}

}  // namespace mechwright
