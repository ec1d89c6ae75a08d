#pragma once
/// \file
/// The formulas by which the links of a four-bar are placed (pose.h) at a given crank angle.
///
/// With d the diagonal from crank pin A to rocker pivot B0, the dyad of coupler and rocker closes where
/// |coupler - rocker| <= d <= coupler + rocker. Both distances to these limits are computed without cancellation
/// (derivation: d^2 = (ground - crank)^2 + 4 ground crank sin^2(theta/2) = (ground + crank)^2 - 4 ground crank
/// cos^2(theta/2); divide the difference of squares by the sum), and every angle of the pose follows from products of
/// them, so that no digit is lost near a toggle or a change point.

#include <cmath>
#include <type_traits>

#include "analysis/four_bar/four_bar.h"
#include "analysis/geometry/half_angle.h"

namespace mechwright {

/// Half of the crank angle as (cos, sin); exact for the crank on the ground line, (1, 0) and (0, 1).
template <class T>
struct HalfTurn {
    T cosine;
    T sine;
};

template <class T>
HalfTurn<T> half_turn(const T& crank_angle) {
    using std::cos, std::sin;
    const T half = T(0.5) * crank_angle;
    return {cos(half), sin(half)};
}

/// The diagonal A-B0 and how far it is from its two limits. The linkage assembles where both margins are >= 0; a
/// negative margin is the length by which it fails.
template <class T>
struct AssemblyMargins {
    T diagonal;
    T stretch;  ///< coupler + rocker - diagonal: zero where coupler and rocker are stretched out
    T fold;     ///< diagonal - |coupler - rocker|: zero where they are folded

    auto closed() const { return both(stretch >= T(0), fold >= T(0)); }
};

template <class T>
inline AssemblyMargins<T> assembly_margins(const FourBar<T>& m, const HalfTurn<T>& half) {
    const auto ground_longer = m.ground >= m.crank;
    const auto coupler_longer = m.coupler >= m.rocker;
    const T outer = select(ground_longer, m.ground, m.crank);
    const T inner = select(ground_longer, m.crank, m.ground);
    const T greater = select(coupler_longer, m.coupler, m.rocker);
    const T lesser = select(coupler_longer, m.rocker, m.coupler);
    const T difference = outer - inner;
    const T sum = outer + inner;
    const T d = hypotenuse(difference * half.cosine, sum * half.sine);
    // Both margins are counted from the nearer of the two positions on the ground line, where the diagonal is
    // outer -+ inner and they are compensated sums of four lengths; `grown` is how much longer the diagonal is here.
    const auto near_zero = half.cosine * half.cosine >= half.sine * half.sine;
    const T signed_inner = select(near_zero, T(-inner), inner);
    const T off_line = select(near_zero, half.sine, half.cosine);
    const T both = d + select(near_zero, difference, sum);
    const auto apart = both > T(0);  // else a kite, its pins together
    const T grown =
        select(apart, T(T(-4) * outer * signed_inner * off_line * off_line / select(apart, both, T(1))), T(0));
    const T stretch = sum_difference(greater, lesser, outer, signed_inner) - grown;
    const T fold = sum_difference(outer, lesser, greater, T(-signed_inner)) + grown;
    // Together they are twice the lesser link. With the greater margin taken from that, the two are rounded alike and
    // the direction of a very short link keeps its unit length.
    const auto fold_least = stretch > fold;
    return {d, select(fold_least, T(T(2) * lesser - fold), stretch),
            select(fold_least, fold, T(T(2) * lesser - stretch))};
}

/// The whole pose. All directions are unit vectors in the frame of the linkage.
template <class T>
struct FourBarPose {
    Vector<T> crank;    ///< from crank pivot to crank pin
    Vector<T> coupler;  ///< from crank pin to rocker pin
    Vector<T> rocker;   ///< from rocker pivot to rocker pin
    /// The angle from coupler to rocker: the transmission angle is its absolute value, |sine| its quality; positive for
    /// the open assembly, negative for the crossed one.
    T transmission_sine;
    T transmission_cosine;
    AssemblyMargins<T> margins;

    /// Whether the loop closes. If not, the pose shown is that of the nearest toggle.
    auto assembled() const { return margins.closed(); }
};

namespace detail {

/// The factors of the half-angle formulas of the triangle A-B0-B. Sixteen times its squared area is stretched folded.
template <class T>
struct Dyad {
    T sum;           ///< coupler + rocker + d
    T coupler_side;  ///< d + coupler - rocker
    T rocker_side;   ///< d - coupler + rocker
    T stretched;     ///< (coupler + rocker)^2 - d^2
    T folded;        ///< d^2 - (coupler - rocker)^2
};

template <class T>
Dyad<T> dyad(const FourBar<T>& m, const AssemblyMargins<T>& margins) {
    using std::abs;
    const T sum = m.coupler + m.rocker + margins.diagonal;
    const T other = margins.diagonal + abs(m.coupler - m.rocker);
    const auto coupler_longer = m.coupler >= m.rocker;
    return {sum, select(coupler_longer, other, margins.fold), select(coupler_longer, margins.fold, other),
            margins.stretch * sum, margins.fold * other};
}

/// The directions of coupler and rocker at the toggle nearest to a position that does not assemble.
template <class T>
void lay_in_line(FourBarPose<T>& p, const FourBar<T>& m, const Vector<T>& along) {
    const auto stretched = p.margins.stretch < T(0);
    p.coupler = stretched || m.coupler >= m.rocker ? along : -along;
    p.rocker = stretched ? -along : p.coupler;
    p.transmission_sine = T(0);
    p.transmission_cosine = stretched ? T(-1) : T(1);
}

/// From crank pin to rocker pivot, times a factor: a unit vector where that is the reciprocal of the diagonal.
template <class T>
Vector<T> along_diagonal(const FourBar<T>& m, const HalfTurn<T>& half, const T& factor) {
    const T cc = half.cosine * half.cosine;
    const T ss = half.sine * half.sine;
    return {((m.ground - m.crank) * cc + (m.ground + m.crank) * ss) * factor,
            -m.crank * (T(2) * half.sine * half.cosine) * factor};
}

/// Law of cosines in the triangle A-B0-B with every factor of its half-angle formulas taken from the margins.
/// `inline`, as in what it calls, tells a compiler to make the pose part of what asks for it: handing it over through
/// memory would take a fifth of its time.
template <class T>
inline FourBarPose<T> pose_by_formulas(const FourBar<T>& m, const HalfTurn<T>& half, Assembly assembly) {
    FourBarPose<T> p;
    p.margins = assembly_margins(m, half);
    const T& d = p.margins.diagonal;
    const T cc = half.cosine * half.cosine;
    const T ss = half.sine * half.sine;
    p.crank = {cc - ss, T(2) * half.sine * half.cosine};
    const auto apart = d > T(0);
    const T inverse = select(apart, T(T(1) / select(apart, d, T(1))), T(0));
    // From crank pin to rocker pivot; where the two coincide, its limit as the crank turns on.
    const Vector<T> along = select(apart, along_diagonal(m, half, inverse), Vector<T>{T(0), T(-1)});
    // One number takes these ways out early; in lanes all go through the formulas below, and a lane that does not
    // assemble is known by its margins.
    if constexpr (std::is_same_v<decltype(p.assembled()), bool>) {
        if (!p.assembled()) {
            lay_in_line(p, m, along);
            return p;
        }
    }
    const Dyad<T> k = dyad(m, p.margins);
    const T side(side_of(assembly));
    const Vector<T> across = side * left_of(along);
    const T double_root = T(2) * root_or_zero(T(k.stretched * k.folded));
    const T per_both = T(1) / (T(4) * m.coupler * m.rocker);
    p.transmission_sine = side * double_root * per_both;
    p.transmission_cosine = (k.stretched - k.folded) * per_both;
    const T per_coupler = inverse / (T(4) * m.coupler);
    const T per_rocker = inverse / (T(4) * m.rocker);
    const T coupler_cosine = (k.sum * k.coupler_side - p.margins.stretch * k.rocker_side) * per_coupler;
    const T rocker_cosine = (k.sum * k.rocker_side - p.margins.stretch * k.coupler_side) * per_rocker;
    p.coupler = coupler_cosine * along + (double_root * per_coupler) * across;
    p.rocker = (double_root * per_rocker) * across - rocker_cosine * along;
    // Else coupler and rocker lie on each other, square to the line their end leaves.
    p.coupler = select(apart, p.coupler, across);
    p.rocker = select(apart, p.rocker, across);
    return p;
}

}  // namespace detail

}  // namespace mechwright
