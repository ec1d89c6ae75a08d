#pragma once
/// \file
/// First derivatives of the coupler point by the implicit function theorem: one division for all of them.
///
/// The loop crank e + coupler w = ground x + rocker v, with e, w, v the unit vectors of crank, coupler and rocker, is
/// differentiated and multiplied by v, which removes the unknown turn of the rocker:
///
///     coupler (left(w) . v) dphi = dground (x . v) + drocker - dcrank (e . v) - dcoupler (w . v)
///                                  - crank (left(e) . v) dtheta,
///
/// with phi the angle of the coupler, theta that of the crank, and left(w) . v = cross(w, v) the sine of the
/// transmission angle: at a toggle, where it vanishes, the derivatives are truly infinite.

#include <array>

#include "analysis/four_bar/coupler_point.h"

namespace mechwright {

/// The derivatives of the angle of the coupler.
template <class T>
struct CouplerTurn {
    std::array<T, 4> links;  ///< with respect to ground, crank, coupler, rocker
    T crank_angle;
};

template <class T>
CouplerTurn<T> coupler_turn(const FourBar<T>& m, const FourBarPose<T>& p) {
    const T per = T(1) / (m.coupler * p.transmission_sine);
    return {{p.rocker.x * per, -dot(p.crank, p.rocker) * per, -p.transmission_cosine * per, per},
            -m.crank * cross(p.crank, p.rocker) * per};
}

/// The derivatives of the coupler point's position in the frame of the linkage, with respect to ground, crank, coupler,
/// rocker, along, across and the crank angle.
template <class T>
std::array<Vector<T>, 7> position_gradient(const FourBar<T>& m, const CouplerPoint<T>& point, const FourBarPose<T>& p) {
    const CouplerTurn<T> turn = coupler_turn(m, p);
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
