#pragma once
/// \file
/// A point of a moving link, and the placement of a mechanism in the drawing.

#include <cmath>

#include "analysis/geometry/vector.h"

namespace mechwright {

/// A point of a link that joins two pins, in the link's own frame: along the line from its first pin to its second, and
/// to the left of that line.
template <class T>
struct CouplerPoint {
    T along;
    T across;
};

/// Where the crank pivot is and where the mechanism's x axis points (radians).
template <class T>
struct Placement {
    Vector<T> origin;
    T tilt;
};

/// A vector of the mechanism's frame, turned into the drawing.
template <class T>
Vector<T> tilted(const Vector<T>& local, const T& tilt) {
    using std::cos, std::sin;
    return turned(local, {cos(tilt), sin(tilt)});
}

/// A position of the mechanism's frame in the drawing.
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
