#pragma once
/// \file
/// Polygons whose sides do not cross.

#include <cstddef>
#include <span>

#include "analysis/geometry/vector.h"

namespace mechwright {

/// The area within, positive where the corners are against the clock: by triangles from the first corner, which loses
/// no digits far from the origin.
inline double area_of(std::span<const Vector<double>> corners) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        twice += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return 0.5 * twice;
}

/// Whether a place is inside, by how often a ray from it meets the sides.
inline bool is_in_polygon(std::span<const Vector<double>> corners, const Vector<double>& place) {
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector<double> a = corners[i] - place, b = corners[(i + 1) % corners.size()] - place;
        if ((a.y > 0) != (b.y > 0) && (cross(a, b) > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

}  // namespace mechwright
