#pragma once
/// \file
/// A point of the rod of a slider-crank: `along` from crank pin to ram, `across` to its left.

#include "analysis/geometry/placement.h"
#include "analysis/slider_crank/velocity.h"

namespace mechwright {

/// Position in the frame of the slide, whose origin is the crank pivot.
template <class T>
Vector<T> position(const SliderCrank<T>& m, const CouplerPoint<T>& point, const SliderCrankPose<T>& p) {
    return m.crank * p.crank + turned({point.along, point.across}, p.rod);
}

/// Velocity in that frame.
template <class T>
Vector<T> velocity(const SliderCrank<T>& m, const CouplerPoint<T>& point, const SliderCrankPose<T>& p,
                   const SliderCrankVelocity<T>& v) {
    return left_of((m.crank * v.crank) * p.crank) + left_of(v.rod * turned({point.along, point.across}, p.rod));
}

/// Acceleration in that frame. Reference: Theory of Machines, equation (4-61).
template <class T>
Vector<T> acceleration(const SliderCrank<T>& m, const CouplerPoint<T>& point, const SliderCrankPose<T>& p,
                       const SliderCrankVelocity<T>& v, const SliderCrankAcceleration<T>& a) {
    const Vector<T> pin = m.crank * p.crank;
    const Vector<T> arm = turned({point.along, point.across}, p.rod);
    return left_of(a.crank * pin + a.rod * arm) - (v.crank * v.crank) * pin - (v.rod * v.rod) * arm;
}

}  // namespace mechwright
