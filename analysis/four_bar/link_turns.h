#pragma once
/// \file
/// How the links of a four-bar turn with its dimensions and its crank: first derivatives by the implicit function
/// theorem, one division for all of them.
///
/// The loop crank e + coupler w = ground x + rocker v, with e, w, v the unit vectors of crank, coupler and rocker, is
/// differentiated and multiplied by v, which removes the unknown turn of the rocker, or by w, which removes that of the
/// coupler:
///
///     coupler (left(w) . v) dphi = dground (x . v) + drocker - dcrank (e . v) - dcoupler (w . v)
///                                  - crank (left(e) . v) dtheta,
///     rocker (left(v) . w) dpsi = dcrank (e . w) + crank (left(e) . w) dtheta + dcoupler - dground (x . w)
///                                 - drocker (v . w),
///
/// with phi, psi and theta the angles of coupler, rocker and crank, and left(w) . v = cross(w, v) = -left(v) . w the
/// sine of the transmission angle: at a toggle, where it vanishes, the derivatives are truly infinite.

#include <array>

#include "analysis/four_bar/pose_formulas.h"

namespace mechwright {

/// The derivatives of the angle of a link, or of a length.
template <class T>
struct LinkTurn {
    std::array<T, 4> links;  ///< with respect to ground, crank, coupler, rocker
    T crank_angle;
};

template <class T>
LinkTurn<T> coupler_turn(const FourBar<T>& m, const FourBarPose<T>& p) {
    const T per = T(1) / (m.coupler * p.transmission_sine);
    return {{p.rocker.x * per, -dot(p.crank, p.rocker) * per, -p.transmission_cosine * per, per},
            -m.crank * cross(p.crank, p.rocker) * per};
}

template <class T>
LinkTurn<T> rocker_turn(const FourBar<T>& m, const FourBarPose<T>& p) {
    const T per = T(1) / (m.rocker * p.transmission_sine);
    return {{p.coupler.x * per, -dot(p.crank, p.coupler) * per, -per, p.transmission_cosine * per},
            -m.crank * cross(p.crank, p.coupler) * per};
}

/// Of the length of the diagonal from crank pin to rocker pivot, ground x - crank e = diagonal a:
/// ddiagonal = dground (x . a) - dcrank (e . a) - crank (left(e) . a) dtheta. Precondition: it is not zero.
template <class T>
LinkTurn<T> diagonal_growth(const FourBar<T>& m, const HalfTurn<T>& half, const FourBarPose<T>& p) {
    const Vector<T> a = detail::along_diagonal(m, half, T(T(1) / p.margins.diagonal));
    return {{a.x, -dot(p.crank, a), T(0), T(0)}, -m.crank * cross(p.crank, a)};
}

}  // namespace mechwright
