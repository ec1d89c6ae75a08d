#pragma once
/// \file
/// First derivatives of the coupler point, by way of the turn of the coupler (link_turns.h).

#include <array>

#include "analysis/four_bar/coupler_point.h"

namespace mechwright {

/// The derivatives of the coupler point's position in the frame of the linkage, with respect to ground, crank, coupler,
/// rocker, along, across and the crank angle.
template <class T>
std::array<Vector<T>, 7> position_gradient(const FourBar<T>& m, const CouplerPoint<T>& point, const FourBarPose<T>& p) {
    const LinkTurn<T> turn = coupler_turn(m, p);
    const Vector<T> swung = left_of(turned({point.along, point.across}, p.coupler));
    return {turn.links[0] * swung,
            turn.links[1] * swung + p.crank,
            turn.links[2] * swung,
            turn.links[3] * swung,
            p.coupler,
            left_of(p.coupler),
            turn.crank_angle * swung + m.crank * left_of(p.crank)};
}

}  // namespace mechwright
