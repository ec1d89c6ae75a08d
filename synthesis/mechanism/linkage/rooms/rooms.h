#pragma once
/// \file
/// The room that parts of a linkage need, and regions of the drawing in which they have to stay, or out of which. Links
/// are the convex outlines of their points. All lengths are those of the file, in the drawing's axes.

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/linkage/structure/structure.h"

namespace mechwright {

/// A box about some pins, turned by an angle, or so that its width or its area is least.
struct LinkageRoom {
    enum class Turn { given, least_width, least_area };
    std::string name;
    std::vector<std::size_t> pins;
    double direction = 0;  ///< of its width, radians, where that is given; its height is across
    Turn turn = Turn::given;
    std::vector<Vector<double>> screen{};  ///< corners against the clock, of what the line between two pins sweeps
};

/// Whether it is about the path of one point, which moves.
inline bool has_path(const linkage::Structure& structure, const LinkageRoom& room) {
    return room.pins.size() == 1 && !linkage::is_on(structure.pins[room.pins.front()], 0);
}

/// Whether it is about two points, so that the line between them sweeps an area; one of them may stay where it is.
inline bool has_blade(const linkage::Structure& structure, const LinkageRoom& room) {
    return room.pins.size() == 2 &&
           !(linkage::is_on(structure.pins[room.pins[0]], 0) && linkage::is_on(structure.pins[room.pins[1]], 0));
}

/// A region that parts of a linkage keep in or out of. One that is a link moves with it.
struct LinkageRegion {
    enum class Shape { half_plane, polygon, circle, link };
    std::string name;
    Shape shape = Shape::polygon;
    bool inside = true;                             ///< they keep in
    std::vector<Vector<double>> places{};           ///< corners against the clock; the centre; a place on the border
    double direction = 0;                           ///< of a half-plane's border, to the left of which it lies
    std::vector<std::size_t> pins{};                ///< of a link
    double radius = 0;                              ///< of a circle; of a link half of its width
    double margin = 0;                              ///< the least that is asked for
    std::vector<std::vector<std::size_t>> parts{};  ///< of each the pins: a point has one
    /// Of a polygon that is not convex: convex parts that cover what has to be free
    /// (analysis/geometry/convex_pieces.h).
    std::vector<std::vector<Vector<double>>> pieces{};

    /// Whether the margin of a part is the least of its points' margins: in a convex region, and out of a half-plane.
    bool is_by_points() const { return pieces.empty() && (inside || shape == Shape::half_plane); }
};

/// A straight border: what is allowed lies on the side to which `inward`, a unit vector, points.
struct StraightBorder {
    Vector<double> through;
    Vector<double> inward;
};

/// Those of a region that is no circle, where parts keep in; of a half-plane also where they keep out.
inline std::vector<StraightBorder> borders_of(const LinkageRegion& region) {
    const auto& places = region.places;
    if (region.shape == LinkageRegion::Shape::half_plane) {
        const Vector<double> left{-std::sin(region.direction), std::cos(region.direction)};
        return {{places.front(), region.inside ? left : -left}};
    }
    std::vector<StraightBorder> borders;
    for (std::size_t i = 0; region.shape == LinkageRegion::Shape::polygon && i < places.size(); ++i) {
        const Vector<double> along = places[(i + 1) % places.size()] - places[i];
        borders.push_back({places[i], (1 / std::hypot(along.x, along.y)) * left_of(along)});
    }
    return borders;
}

}  // namespace mechwright
