#pragma once
/// \file
/// First derivatives of a point of the rod by the implicit function theorem.
///
/// The loop crank e + rod w = (s, offset), with e and w the unit vectors of crank and rod, is differentiated; its
/// component across the slide does not hold the unknown position s of the ram:
///
///     rod w.x dphi = doffset - dcrank e.y - drod w.y - crank e.x dtheta,
///
/// with phi the angle of the rod and theta that of the crank: where the rod stands square to the slide, w.x = 0, the
/// derivatives are truly infinite.

#include <array>

#include "analysis/slider_crank/rod_point.h"

namespace mechwright {

/// The derivatives of the angle of the rod.
template <class T>
struct RodTurn {
    std::array<T, 3> dimensions;  ///< with respect to crank, rod, offset
    T crank_angle;
};

template <class T>
RodTurn<T> rod_turn(const SliderCrank<T>& m, const SliderCrankPose<T>& p) {
    const T per = T(1) / (m.rod * p.rod.x);
    return {{-p.crank.y * per, -p.rod.y * per, per}, -m.crank * p.crank.x * per};
}

/// The derivatives of the rod point's position in the frame of the slide, with respect to crank, rod, offset, along,
/// across and the crank angle.
template <class T>
std::array<Vector<T>, 6> position_gradient(const SliderCrank<T>& m, const CouplerPoint<T>& point,
                                           const SliderCrankPose<T>& p) {
    const RodTurn<T> turn = rod_turn(m, p);
    const Vector<T> swung = left_of(turned({point.along, point.across}, p.rod));
    return {turn.dimensions[0] * swung + p.crank,
            turn.dimensions[1] * swung,
            turn.dimensions[2] * swung,
            p.rod,
            left_of(p.rod),
            turn.crank_angle * swung + m.crank * left_of(p.crank)};
}

}  // namespace mechwright
