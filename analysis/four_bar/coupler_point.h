#pragma once
/// \file
/// A point of the coupler: `along` the line from crank pin to rocker pin, `across` to its left; and the placement of
/// the linkage in the drawing.

#include "analysis/four_bar/velocity.h"

namespace mechwright {

template <class T>
struct CouplerPoint {
    T along;
    T across;
};

/// Where the crank pivot is and where the ground link points (radians).
template <class T>
struct Placement {
    Vector<T> origin;
    T tilt;
};

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

/// A vector of the linkage's frame, turned into the drawing.
template <class T>
Vector<T> tilted(const Vector<T>& local, const T& tilt) {
    using std::cos, std::sin;
    return turned(local, {cos(tilt), sin(tilt)});
}

/// A position of the linkage's frame in the drawing.
template <class T>
Vector<T> placed(const Vector<T>& local, const Placement<T>& placement) {
    return placement.origin + tilted(local, placement.tilt);
}

/// From the coupler point to a target in the drawing. The pivot is subtracted from the target first, so that a linkage
/// far from the origin keeps its digits.
template <class T>
Vector<T> miss(const Vector<T>& local, const Placement<T>& placement, const Vector<T>& target) {
    return (target - placement.origin) - tilted(local, placement.tilt);
}

}  // namespace mechwright
