#pragma once
/// \file
/// Polygons of which a blade sweeps a part.

#include <cstddef>
#include <span>
#include <vector>

#include "synthesis/mechanism/linkage/measured_over.h"

namespace mechwright::measuring {

/// Whether a place is in a polygon whose sides do not cross, by how often a ray from it meets them.
inline bool is_in_polygon(std::span<const Vector<double>> corners, const Vector<double>& place) {
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector<double> a = corners[i] - place, b = corners[(i + 1) % corners.size()] - place;
        if ((a.y > 0) != (b.y > 0) && (cross(a, b) > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

/// That of a polygon whose corners are against the clock.
inline double area_of(std::span<const Vector<double>> corners) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        twice += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return 0.5 * twice;
}

/// The screen of the room that is measured, in the lengths of its model.
inline std::vector<Vector<double>> screen_of(const Over& over) {
    std::vector<Vector<double>> corners;
    for (const Vector<double>& corner : over.model.rooms[over.measure.of_room].screen)
        corners.push_back((1 / over.model.unit) * corner);
    return corners;
}

}  // namespace mechwright::measuring
