#include "synthesis/mechanism/linkage/again/regions_again.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/again/least_of_several.h"

namespace mechwright::again {

namespace {

template <class T>
Vector<T> as(const Vector<double>& at) {
    return {T(at.x), T(at.y)};
}

/// How far a point is inside of a region; negative outside, then by how much it is beyond a border.
template <class T>
T inside_by(const Vector<T>& at, const LinkageRegion& region) {
    using std::cos, std::sin;
    if (region.shape == LinkageRegion::Shape::circle) {
        const Vector<T> from = at - as<T>(region.places.front());
        return T(region.radius) - hypotenuse(from.x, from.y);
    }
    if (region.shape == LinkageRegion::Shape::half_plane)
        return cross(Vector<T>{cos(T(region.direction)), sin(T(region.direction))}, at - as<T>(region.places.front()));
    T least(0);
    for (std::size_t i = 0; i < region.places.size(); ++i) {
        const Vector<T> corner = as<T>(region.places[i]),
                        side = as<T>(region.places[(i + 1) % region.places.size()]) - corner;
        const T one = T(cross(side, at - corner) / hypotenuse(side.x, side.y));
        if (i == 0 || one < least) least = one;
    }
    return least;
}

/// The margin of a region where it is that of points.
Digits50 margin_of_points(const Scan& scan, const LinkageRegion& region) {
    std::vector<std::size_t> pins;
    for (const auto& part : region.parts)
        pins.insert(pins.end(), part.begin(), part.end());
    return least_of_several(scan, pins.size(), [&]<class T>(std::size_t k, const PoseSignals<T>& pose) {
        const T by = inside_by(pose.in_drawing(pins[k]), region);
        return region.inside ? by : T(-by);
    });
}

/// The distance of a point from a segment.
template <class T>
T distance_from_segment(const Vector<T>& at, const Vector<T>& a, const Vector<T>& b) {
    const Vector<T> side = b - a, way = at - a;
    const T square = dot(side, side), along = dot(side, way);
    const Vector<T> from = !(along > T(0)) ? way : along < square ? way - T(along / square) * side : at - b;
    return hypotenuse(from.x, from.y);
}

/// How far the hulls of two sets of points are apart, by all pairs of points of each: overlapping, by all directions
/// across these; else the least distance of a point from a segment.
template <class T>
T apart(const std::vector<Vector<T>>& first, const std::vector<Vector<T>>& second) {
    T deepest(-std::numeric_limits<double>::infinity()), nearest(std::numeric_limits<double>::infinity());
    for (const auto& [one, other] : {std::pair(&first, &second), {&second, &first}})
        for (const Vector<T>& a : *one)
            for (const Vector<T>& b : *one) {
                for (const Vector<T>& at : *other)
                    nearest = std::min<T>(nearest, distance_from_segment(at, a, b));
                const Vector<T> side = b - a;
                const T length = hypotenuse(side.x, side.y);
                if (!(length > T(0))) continue;
                T least(std::numeric_limits<double>::infinity()), most = -least;
                for (const Vector<T>& at : *other)
                    least = std::min<T>(least, cross(side, at - a) / length);
                for (const Vector<T>& at : *one)
                    most = std::max<T>(most, cross(side, at - a) / length);
                deepest = std::max<T>(deepest, least - most);
            }
    return deepest < T(0) && (first.size() > 1 || second.size() > 1) ? deepest : nearest;
}

/// Whether a place is inside of a polygon: a ray from it crosses an odd number of sides.
template <class T>
bool is_inside(const Vector<T>& at, const std::vector<Vector<T>>& polygon) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector<T>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y > at.y) == (b.y > at.y)) continue;
        if ((cross(b - a, at - a) > T(0)) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

template <class T>
bool do_cross(const Vector<T>& a, const Vector<T>& b, const Vector<T>& from, const Vector<T>& to) {
    const auto are_apart = [](const Vector<T>& one, const Vector<T>& other, const Vector<T>& p, const Vector<T>& q) {
        return (cross(other - one, p - one) > T(0)) != (cross(other - one, q - one) > T(0));
    };
    return are_apart(a, b, from, to) && are_apart(from, to, a, b);
}

/// How deep a part is in convex parts of what has to be free: in that in which it is deepest.
template <class T>
T deepest_in_pieces(const std::vector<Vector<T>>& part, const LinkageRegion& region) {
    T least(std::numeric_limits<double>::infinity());
    for (const auto& piece : region.pieces) {
        std::vector<Vector<T>> outline;
        for (const Vector<double>& corner : piece)
            outline.push_back(as<T>(corner));
        if (outline.size() > 2) {
            least = std::min<T>(least, apart(part, outline));
            continue;
        }
        const Vector<T> along = outline.back() - outline.front();
        for (const Vector<T>& at : part)
            least = std::min<T>(least, cross(at - outline.front(), along) / hypotenuse(along.x, along.y));
    }
    return least;
}

/// How far a part is from what of a polygon has to be free, by its border alone where
/// nothing overlaps: nothing crosses the border, and a place is on the right side of it.
template <class T>
T free_of_polygon(const std::vector<Vector<T>>& part, const LinkageRegion& region) {
    std::vector<Vector<T>> polygon;
    for (const Vector<double>& corner : region.places)
        polygon.push_back(as<T>(corner));
    const std::size_t n = polygon.size();
    bool overlaps = is_inside(part.front(), polygon) != region.inside ||
                    (!region.inside && part.size() > 2 && apart(part, std::vector{polygon.front()}) < T(0));
    T nearest(std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < n; ++i)
        for (const Vector<T>& a : part)
            for (const Vector<T>& b : part) {
                const Vector<T>&from = polygon[i], &to = polygon[(i + 1) % n];
                overlaps = overlaps || do_cross(a, b, from, to);
                nearest = std::min<T>(nearest, distance_from_segment(a, from, to));
                nearest = std::min<T>(nearest, distance_from_segment(from, a, b));
            }
    return overlaps ? deepest_in_pieces(part, region) : nearest;
}

/// Where links keep out of a polygon, a circle or another link, or in a polygon that is not convex.
Digits50 margin_outside(const Scan& scan, const LinkageRegion& region) {
    return least_of_several(scan, region.parts.size(), [&region]<class T>(std::size_t k, const PoseSignals<T>& pose) {
        std::vector<Vector<T>> part, outline;
        for (const std::size_t pin : region.parts[k])
            part.push_back(pose.in_drawing(pin));
        if (!region.pieces.empty()) return free_of_polygon(part, region);
        for (const Vector<double>& place : region.places)
            outline.push_back(as<T>(place));
        for (const std::size_t pin : region.pins)
            outline.push_back(pose.in_drawing(pin));
        return T(apart(part, outline) - T(region.radius));
    });
}

}  // namespace

Digits50 margin_of_region(const Scan& scan, const LinkageRegion& region) {
    return region.is_by_points() ? margin_of_points(scan, region) : margin_outside(scan, region);
}

}  // namespace mechwright::again
