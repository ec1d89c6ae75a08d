#pragma once
/// \file
/// Convex parts that cover a simple polygon, or all that is outside of one. They overlap: whatever is inside of what
/// they cover is inside of one of them, so that a convex outline overlaps it where it overlaps one of them, and is as
/// far from it as from the nearest. Any unit of length.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/geometry/separation.h"

namespace mechwright {

using Corners = std::vector<Vector<double>>;

namespace detail {

inline constexpr double straight = 1e-12;  ///< less of its size is rounding

inline double length_of(const Vector<double>& way) { return std::hypot(way.x, way.y); }

inline double size_of(const Corners& corners) {
    double size = 0;
    for (const Vector<double>& corner : corners)
        size = std::max(size, length_of(corner - corners.front()));
    return size;
}

/// Twice the area of a corner and its neighbours, negative where the outline turns to the right.
inline double turn_at(const Corners& corners, std::size_t i) {
    const std::size_t n = corners.size();
    return cross(corners[i] - corners[(i + n - 1) % n], corners[(i + 1) % n] - corners[i]);
}

/// Without corners that are where another is, or on a side.
inline Corners without_straight(Corners corners) {
    const double size = size_of(corners);
    for (std::size_t i = 0; corners.size() > 2 && i < corners.size();) {
        const std::size_t n = corners.size();
        const Vector<double> before = corners[i] - corners[(i + n - 1) % n], after = corners[(i + 1) % n] - corners[i];
        const bool is_straight =
            std::abs(cross(before, after)) <= straight * size * std::max(length_of(before), length_of(after));
        if (is_straight) {
            corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
            i = 0;
        } else {
            ++i;
        }
    }
    return corners;
}

/// Where a ray from a corner into a polygon first meets a side, and where that side begins.
struct Met {
    std::size_t side = 0;
    Vector<double> at{};
};

inline std::optional<Met> first_met(const Corners& corners, std::size_t from, const Vector<double>& way) {
    const std::size_t n = corners.size();
    const double size = size_of(corners), within = straight * size;
    const Vector<double> along = (1 / length_of(way)) * way;
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<Met> met;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t next = (k + 1) % n;
        if (k == from || next == from) continue;
        const Vector<double> side = corners[next] - corners[k], to = corners[k] - corners[from];
        const double length = length_of(side), across = cross(along, side);
        if (std::abs(across) <= straight * length) continue;
        const double far = cross(to, side) / across, share = cross(to, along) / across;
        if (far <= within || share * length < -within || (share - 1) * length > within || far >= nearest) continue;
        nearest = far;
        met = Met{k, corners[k] + share * side};
        if (std::abs(share) * length <= within) met->at = corners[k];
        if (std::abs(share - 1) * length <= within) met->at = corners[next];
    }
    return met;
}

/// The part of a polygon that has the side before (or after) an inward corner, cut along this side's line: the corner
/// is none of it.
inline std::optional<Corners> cut_along_side(const Corners& corners, std::size_t corner, bool before) {
    const std::size_t n = corners.size();
    const Vector<double>& neighbour = corners[(corner + (before ? n - 1 : 1)) % n];
    const auto met = first_met(corners, corner, corners[corner] - neighbour);
    if (!met) return {};
    Corners part{met->at};
    const std::size_t first = before ? (met->side + 1) % n : corner, last = before ? corner : met->side;
    for (std::size_t i = first;; i = (i + 1) % n) {
        part.push_back(corners[i]);
        if (i == last) break;
    }
    return without_straight(std::move(part));
}

/// Whether a convex polygon is inside of another.
inline bool is_in(const Corners& inner, const Corners& outer) {
    const double within = straight * size_of(outer);
    for (std::size_t i = 0; i < outer.size(); ++i) {
        const Vector<double> side = outer[(i + 1) % outer.size()] - outer[i];
        for (const Vector<double>& corner : inner)
            if (cross(side, corner - outer[i]) < -within * length_of(side)) return false;
    }
    return true;
}

inline void add_piece(Corners piece, std::vector<Corners>& pieces) {
    for (const Corners& other : pieces)
        if (is_in(piece, other)) return;
    std::erase_if(pieces, [&](const Corners& other) { return is_in(other, piece); });
    pieces.push_back(std::move(piece));
}

inline bool is_inward(const Corners& corners, std::size_t i) {
    const double size = size_of(corners);
    return turn_at(corners, i) < -straight * size * size;
}

/// False where it takes more than `cuts`.
inline bool add_pieces(const Corners& corners, std::vector<Corners>& pieces, std::size_t& cuts) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (!is_inward(corners, i)) continue;
        if (cuts == 0) return false;
        --cuts;
        for (const bool before : {true, false}) {
            const auto part = cut_along_side(corners, i, before);
            if (!part || !add_pieces(*part, pieces, cuts)) return false;
        }
        return true;
    }
    add_piece(corners, pieces);
    return true;
}

inline constexpr std::size_t most_cuts = 512;

}  // namespace detail

/// Whether a polygon whose corners are against the clock has no inward corner.
inline bool is_convex(const Corners& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        if (detail::is_inward(polygon, i)) return false;
    return true;
}

/// Convex parts that cover a polygon whose corners are against the clock and whose sides do not meet: at an inward
/// corner it is what lies on the inner side of the one side's line, and what does of the other's, again and again. Two
/// of an L, its bars. Absent where too many cuts are needed.
inline std::optional<std::vector<Corners>> convex_pieces(const Corners& polygon) {
    std::vector<Corners> pieces;
    std::size_t cuts = detail::most_cuts;
    return detail::add_pieces(detail::without_straight(polygon), pieces, cuts) ? std::optional(std::move(pieces))
                                                                               : std::nullopt;
}

/// The same of all that is outside of it. Parts with two corners are half-planes, to the left of the line from the
/// first to the second: those beyond the sides of its convex hull. Others are of what is cut from the hull and reach
/// out of it, to a hundred times the polygon's size.
inline std::optional<std::vector<Corners>> convex_pieces_outside(const Corners& polygon) {
    constexpr double beyond = 100;
    const Corners corners = detail::without_straight(polygon);
    const std::vector<std::size_t> hull = convex_hull(corners);
    const double far = beyond * detail::size_of(corners);
    std::vector<Corners> all;
    std::size_t cuts = detail::most_cuts;
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const std::size_t from = hull[k], to = hull[(k + 1) % hull.size()];
        const Vector<double>&a = corners[from], &b = corners[to];
        all.push_back({b, a});
        if ((from + 1) % corners.size() == to) continue;
        const Vector<double> along = (far / detail::length_of(b - a)) * (b - a), out = -left_of(along);
        Corners open{a - along + out, b + along + out, b + along, b};
        for (std::size_t i = (to + corners.size() - 1) % corners.size(); i != from;
             i = (i + corners.size() - 1) % corners.size())
            open.push_back(corners[i]);
        open.insert(open.end(), {a, a - along});
        std::vector<Corners> pieces;
        if (!detail::add_pieces(open, pieces, cuts)) return {};
        const auto is_outside = [&](const Corners& piece) {
            return std::all_of(piece.begin(), piece.end(), [&](const Vector<double>& corner) {
                return cross(b - a, corner - a) <= detail::straight * far * detail::length_of(b - a);
            });
        };
        for (Corners& piece : pieces)
            if (!is_outside(piece)) all.push_back(std::move(piece));
    }
    return all;
}

/// Where sides of a polygon that are not neighbours meet; absent where none do.
inline std::optional<Vector<double>> crossing_of_sides(const Corners& corners) {
    const std::size_t n = corners.size();
    const double within = detail::straight * detail::size_of(corners);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 2; k < n; ++k) {
            if (i == 0 && k + 1 == n) continue;
            const Vector<double> one = corners[i + 1] - corners[i], other = corners[(k + 1) % n] - corners[k],
                                 to = corners[k] - corners[i];
            const double across = cross(one, other), length = detail::length_of(one),
                         other_length = detail::length_of(other);
            if (std::abs(across) > detail::straight * length * other_length) {
                const double share = cross(to, other) / across, of_other = cross(to, one) / across;
                const auto is_on_side = [&](double part, double of) {
                    return part * of >= -within && (part - 1) * of <= within;
                };
                if (is_on_side(share, length) && is_on_side(of_other, other_length)) return corners[i] + share * one;
                continue;
            }
            if (std::abs(cross(to, one)) > within * length) continue;
            for (const Vector<double>& corner : {corners[k], corners[(k + 1) % n]})
                if (const double along = dot(corner - corners[i], one); along >= 0 && along <= length * length)
                    return corner;
            if (const double along = dot(corners[i] - corners[k], other);
                along >= 0 && along <= other_length * other_length)
                return corners[i];
        }
    return {};
}

}  // namespace mechwright
