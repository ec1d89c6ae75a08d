#pragma once
/// \file
/// Where the links and pins of a linkage are, and how far its dyads are from their limits: what placing (place.h)
/// writes.

#include <cmath>
#include <cstddef>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/linkage/structure/steps.h"
#include "analysis/linkage/structure/structure.h"

namespace mechwright::linkage {

/// A link in the frame of the linkage.
template <class T>
struct LinkPlace {
    Vector<T> origin{};
    Vector<T> along{T(1), T(0)};  ///< its x axis, a unit vector

    Vector<T> at(const Vector<T>& own) const { return origin + turned(own, along); }
};

/// How far a dyad is from its two limits; it closes where both are >= 0.
/// rrr: stretched out (the sum of its lengths less the distance of its outer pins), folded (that distance less their
/// difference); rrp: the link's length less the distance of its pin from the line, to its left and to its right; rpr:
/// the distance of the pins less that of line and pin, the same; two lines: the
/// sine of the angle between them, and -1 where they are parallel; a stop: how far it is, twice. Not a number where the
/// outer pins of a dyad coincide.
template <class T>
struct Margin {
    T outer{};
    T inner{};
};

/// Where everything is. Made once, written at every crank angle.
template <class T>
struct Pose {
    std::vector<LinkPlace<T>> links;
    std::vector<Vector<T>> pins;
    std::vector<T> turns;  ///< of links whose turn is asked for by a gear or known anyway
    std::vector<Margin<T>> margins;
};

template <class T>
Pose<T> empty_pose(const Structure& s, const Order& order) {
    return {std::vector<LinkPlace<T>>(s.links), std::vector<Vector<T>>(s.pins.size(), Vector<T>{T(0), T(0)}),
            std::vector<T>(s.links, T(0)), std::vector<Margin<T>>(order.margins)};
}

namespace detail {

template <class T>
Vector<T> conjugate(const Vector<T>& a) {
    return {a.x, -a.y};
}

}  // namespace detail

}  // namespace mechwright::linkage
