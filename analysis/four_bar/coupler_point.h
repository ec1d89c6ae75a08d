#pragma once
/// \file
/// A point of the coupler: `along` the line from crank pin to rocker pin, `across` to its left.

#include "analysis/four_bar/velocity.h"
#include "analysis/geometry/placement.h"

namespace mechwright {

/// Position in the frame of the linkage, whose origin is the crank pivot.
template <class T>
Vector<T> position(const FourBar<T>& m, const CouplerPoint<T>& point, const FourBarPose<T>& p) {
    return m.crank * p.crank + turned({point.along, point.across}, p.coupler);
}

/// Velocity in the frame of the linkage.
template <class T>
Vector<T> velocity(const FourBar<T>& m, const CouplerPoint<T>& point, const FourBarPose<T>& p,
                   const FourBarVelocity<T>& v) {
    return left_of((m.crank * v.crank) * p.crank) + left_of(v.coupler * turned({point.along, point.across}, p.coupler));
}

/// Acceleration in the frame of the linkage.
template <class T>
Vector<T> acceleration(const FourBar<T>& m, const CouplerPoint<T>& point, const FourBarPose<T>& p,
                       const FourBarVelocity<T>& v, const FourBarAcceleration<T>& a) {
    const Vector<T> pin = m.crank * p.crank;
    const Vector<T> arm = turned({point.along, point.across}, p.coupler);
    return left_of(a.crank * pin + a.coupler * arm) - (v.crank * v.crank) * pin - (v.coupler * v.coupler) * arm;
}

}  // namespace mechwright
