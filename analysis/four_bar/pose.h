#pragma once
/// \file
/// Where the links of a four-bar are at a given crank angle.
///
/// With d the diagonal from crank pin A to rocker pivot B0, the dyad of coupler and rocker closes where
/// |coupler - rocker| <= d <= coupler + rocker. Both distances to these limits are computed without cancellation
/// (derivation: subtract (coupler +- rocker) from d^2 = (ground - crank)^2 + 4 ground crank sin^2(theta/2)), and every
/// angle of the pose follows from products of them, so that no digit is lost near a toggle or a change point.

#include <cmath>

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
};

template <class T>
AssemblyMargins<T> assembly_margins(const FourBar<T>& m, const HalfTurn<T>& half) {
    using std::abs, std::hypot;
    const T difference = abs(m.ground - m.crank);
    const T d = hypot(difference * half.cosine, (m.ground + m.crank) * half.sine);
    const T product = T(4) * m.ground * m.crank;
    const T stretch = sum_difference(m.coupler, m.rocker, m.ground, m.crank) +
                      product * half.cosine * half.cosine / ((m.ground + m.crank) + d);
    // |ground - crank| - |coupler - rocker| as one compensated sum of four lengths.
    const bool ground_longer = m.ground >= m.crank;
    const bool coupler_longer = m.coupler >= m.rocker;
    const T outer = select(ground_longer, m.ground, m.crank);
    const T inner = select(ground_longer, m.crank, m.ground);
    const T lesser = select(coupler_longer, m.rocker, m.coupler);
    const T greater = select(coupler_longer, m.coupler, m.rocker);
    T fold = sum_difference(outer, lesser, inner, greater);
    const T below = d + difference;
    if (below > T(0)) fold += product * half.sine * half.sine / below;  // else the kite with its pins together
    return {d, stretch, fold};
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
    bool assembled() const { return margins.stretch >= T(0) && margins.fold >= T(0); }
};

namespace detail {

/// The three factor pairs of the closed dyad and the root that tells its two assemblies apart.
template <class T>
struct Dyad {
    T sum;            ///< coupler + rocker + d
    T coupler_side;   ///< d + coupler - rocker
    T rocker_side;    ///< d - coupler + rocker
    T stretched;      ///< (coupler + rocker)^2 - d^2
    T folded;         ///< d^2 - (coupler - rocker)^2
    T root;           ///< sqrt(stretched folded), four times the area of the triangle; 0 where it does not close
};

template <class T>
Dyad<T> dyad(const FourBar<T>& m, const AssemblyMargins<T>& margins) {
    using std::abs;
    const T sum = m.coupler + m.rocker + margins.diagonal;
    const T other = margins.diagonal + abs(m.coupler - m.rocker);
    const bool coupler_longer = m.coupler >= m.rocker;
    const T stretched = margins.stretch * sum;
    const T folded = margins.fold * other;
    const bool closes = margins.stretch >= T(0) && margins.fold >= T(0);
    return {sum,
            select(coupler_longer, other, margins.fold),
            select(coupler_longer, margins.fold, other),
            stretched,
            folded,
            closes ? root_or_zero(T(stretched * folded)) : T(0)};
}

}  // namespace detail

/// The pose at the crank angle whose half is `half`, in the given assembly. Law of cosines in the triangle A-B0-B with
/// every factor of its half-angle formulas taken from the margins.
template <class T>
FourBarPose<T> pose(const FourBar<T>& m, const HalfTurn<T>& half, Assembly assembly) {
    const AssemblyMargins<T> margins = assembly_margins(m, half);
    const T& d = margins.diagonal;
    const detail::Dyad<T> k = detail::dyad(m, margins);
    const T side(side_of(assembly));

    const T cc = half.cosine * half.cosine;
    const T ss = half.sine * half.sine;
    const Vector<T> crank{cc - ss, T(2) * half.sine * half.cosine};
    Vector<T> along{T(1), T(0)};  // from crank pin to rocker pivot
    T inverse(0);
    if (d > T(0)) {
        inverse = T(1) / d;
        along = {((m.ground - m.crank) * cc + (m.ground + m.crank) * ss) * inverse, -m.crank * crank.y * inverse};
    }
    const Vector<T> across = left_of(along);

    const T per_coupler = inverse / (T(4) * m.coupler);
    const T per_rocker = inverse / (T(4) * m.rocker);
    const T coupler_cosine = (k.sum * k.coupler_side - margins.stretch * k.rocker_side) * per_coupler;
    const T rocker_cosine = (k.sum * k.rocker_side - margins.stretch * k.coupler_side) * per_rocker;
    const T double_root = T(2) * side * k.root;

    FourBarPose<T> p;
    p.crank = crank;
    p.coupler = coupler_cosine * along + (double_root * per_coupler) * across;
    p.rocker = (double_root * per_rocker) * across - rocker_cosine * along;
    const T per_both = T(1) / (T(4) * m.coupler * m.rocker);
    p.transmission_sine = double_root * per_both;
    p.transmission_cosine = (k.stretched - k.folded) * per_both;
    p.margins = margins;
    return p;
}

/// The pose at a crank angle in radians, counted from the ground link.
template <class T>
FourBarPose<T> pose(const FourBar<T>& m, const T& crank_angle, Assembly assembly) {
    return pose(m, half_turn(crank_angle), assembly);
}

}  // namespace mechwright
