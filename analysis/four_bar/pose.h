#pragma once
/// \file
/// Where the links of a four-bar are at a given crank angle.

#include <cstddef>

#include "analysis/four_bar/link_turns.h"
#include "analysis/numbers/dual.h"

namespace mechwright {

/// The pose at the crank angle whose half is `half`, in the given assembly.
template <class T>
inline FourBarPose<T> pose(const FourBar<T>& m, const HalfTurn<T>& half, Assembly assembly) {
    return detail::pose_by_formulas(m, half, assembly);
}

namespace detail {

/// A unit vector that turns by an angle with these derivatives.
template <class T, std::size_t N>
Vector<Dual<T, N>> turning(const Vector<T>& unit, const std::array<T, N>& turn) {
    Vector<Dual<T, N>> v{unit.x, unit.y};
    for (std::size_t i = 0; i < N; ++i) {
        v.x.partial[i] = -unit.y * turn[i];
        v.y.partial[i] = unit.x * turn[i];
    }
    return v;
}

/// The derivatives of what depends on links and crank angle by whatever those depend on.
template <class T, std::size_t N>
std::array<T, N> chained(const LinkTurn<T>& turn, const FourBar<Dual<T, N>>& m, const std::array<T, N>& crank_angle) {
    std::array<T, N> all;
    for (std::size_t i = 0; i < N; ++i)
        all[i] = turn.links[0] * m.ground.partial[i] + turn.links[1] * m.crank.partial[i] +
                 turn.links[2] * m.coupler.partial[i] + turn.links[3] * m.rocker.partial[i] +
                 turn.crank_angle * crank_angle[i];
    return all;
}

}  // namespace detail

/// The same with first derivatives by way of the turns of the links, at a fraction of what the formulas cost in dual
/// numbers. The value has the same bits.
template <class T, std::size_t N>
FourBarPose<Dual<T, N>> pose(const FourBar<Dual<T, N>>& m, const HalfTurn<Dual<T, N>>& half, Assembly assembly) {
    const FourBar<T> links{m.ground.value, m.crank.value, m.coupler.value, m.rocker.value};
    const HalfTurn<T> at{half.cosine.value, half.sine.value};
    const FourBarPose<T> p = pose(links, at, assembly);
    // At a toggle and where crank pin and rocker pivot coincide the turns are infinite.
    if (!p.assembled() || p.transmission_sine == T(0) || !(p.margins.diagonal > T(0)))
        return detail::pose_by_formulas(m, half, assembly);
    std::array<T, N> crank_angle;
    for (std::size_t i = 0; i < N; ++i)
        crank_angle[i] = T(2) * (half.cosine.value * half.sine.partial[i] - half.sine.value * half.cosine.partial[i]);
    const auto coupler = detail::chained(coupler_turn(links, p), m, crank_angle);
    const auto rocker = detail::chained(rocker_turn(links, p), m, crank_angle);
    const auto diagonal = detail::chained(diagonal_growth(links, at, p), m, crank_angle);
    FourBarPose<Dual<T, N>> d{detail::turning(p.crank, crank_angle),
                              detail::turning(p.coupler, coupler),
                              detail::turning(p.rocker, rocker),
                              p.transmission_sine,
                              p.transmission_cosine,
                              {p.margins.diagonal, p.margins.stretch, p.margins.fold}};
    const T sign = links.coupler >= links.rocker ? T(1) : T(-1);
    for (std::size_t i = 0; i < N; ++i) {
        const T turn = rocker[i] - coupler[i];
        d.transmission_sine.partial[i] = p.transmission_cosine * turn;
        d.transmission_cosine.partial[i] = -p.transmission_sine * turn;
        d.margins.diagonal.partial[i] = diagonal[i];
        d.margins.stretch.partial[i] = m.coupler.partial[i] + m.rocker.partial[i] - diagonal[i];
        d.margins.fold.partial[i] = diagonal[i] - sign * (m.coupler.partial[i] - m.rocker.partial[i]);
    }
    return d;
}

/// The pose at a crank angle in radians, counted from the ground link.
template <class T>
FourBarPose<T> pose(const FourBar<T>& m, const T& crank_angle, Assembly assembly) {
    return pose(m, half_turn(crank_angle), assembly);
}

}  // namespace mechwright
