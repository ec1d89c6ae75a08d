#pragma once
/// \file
/// How far two convex outlines are apart, and which of their corners and sides say it. Outlines have their corners
/// against the clock; two corners are a bar, one is a point.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "analysis/geometry/vector.h"

namespace mechwright {

/// The positions of those points that are corners of their convex hull, against the clock (Andrew's monotone chain; A.
/// M. Andrew, Another efficient algorithm for convex hulls in two dimensions, Information Processing Letters 9 (1979),
/// 216-219). Points that lie on a side within rounding are left out; all that is at one place is one point.
inline std::vector<std::size_t> convex_hull(std::span<const Vector<double>> points) {
    constexpr double rounding = 1e-14;
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) {
        const Vector<double>&a = points[i], &b = points[k];
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    });
    if (order.size() < 2) return order;
    double size = 0;
    for (const Vector<double>& p : points)
        size = std::max(size, std::hypot(p.x - points[order.front()].x, p.y - points[order.front()].y));
    std::vector<std::size_t> hull;
    const auto add_chain = [&](auto from, auto to) {
        const std::size_t start = hull.size();
        for (auto i = from; i != to; ++i) {
            const Vector<double>& p = points[*i];
            while (hull.size() >= start + 2) {
                const Vector<double>&last = points[hull.back()], &before = points[hull[hull.size() - 2]];
                if (cross(last - before, p - last) > 0) break;
                hull.pop_back();
            }
            const auto is_last = [&] {
                const Vector<double> way = p - points[hull.back()];
                return std::hypot(way.x, way.y) <= rounding * size;
            };
            if (hull.size() == start || !is_last()) hull.push_back(*i);
        }
        hull.pop_back();
    };
    add_chain(order.begin(), order.end());
    add_chain(order.rbegin(), order.rend());
    if (hull.empty()) hull.push_back(order.front());
    // Only what lies between its neighbours is on a side: of points in a line the last is a corner.
    for (std::size_t i = 0; i < hull.size() && hull.size() > 2;) {
        const Vector<double>&here = points[hull[i]], before = points[hull[(i + hull.size() - 1) % hull.size()]],
              after = points[hull[(i + 1) % hull.size()]];
        const bool on_side = cross(here - before, after - here) <= rounding * size * size;
        if (on_side && dot(here - before, after - here) > 0)
            hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
    return hull;
}

/// How far two outlines are apart: their distance; where they overlap, the negative of the shortest way that takes them
/// apart. It is the distance of two corners, or that of a corner from the line of a side.
struct Separation {
    enum class Of { corners, side_of_first, side_of_second };
    double distance = std::numeric_limits<double>::infinity();
    Of of = Of::corners;
    std::size_t first = 0;   ///< the corner of the first outline, or where its side begins
    std::size_t second = 0;  ///< the same of the second

    bool is_of_same(const Separation& other) const {
        return of == other.of && first == other.first && second == other.second;
    }
};

namespace detail {

/// The side of `a` beyond which `b` is farthest, or least deep; none of a point.
template <class Take>
void farthest_side(std::span<const Vector<double>> a, std::span<const Vector<double>> b, const Take& take) {
    for (std::size_t i = 0; a.size() > 1 && i < a.size(); ++i) {
        const Vector<double> side = a[(i + 1) % a.size()] - a[i];
        const double length = std::hypot(side.x, side.y);
        double least = std::numeric_limits<double>::infinity();
        std::size_t nearest = 0;
        for (std::size_t k = 0; k < b.size(); ++k)
            if (const double beyond = -cross(side, b[k] - a[i]) / length; beyond < least) {
                least = beyond;
                nearest = k;
            }
        take(least, i, nearest);
    }
}

/// Distances of corners of `b` from sides of `a` whose feet are on these.
template <class Take>
void feet_on_sides(std::span<const Vector<double>> a, std::span<const Vector<double>> b, const Take& take) {
    for (std::size_t i = 0; a.size() > 1 && i < a.size(); ++i) {
        const Vector<double> side = a[(i + 1) % a.size()] - a[i];
        const double length = std::hypot(side.x, side.y);
        for (std::size_t k = 0; k < b.size(); ++k) {
            const Vector<double> way = b[k] - a[i];
            const double along = dot(side, way), beyond = -cross(side, way) / length;
            if (beyond >= 0 && along > 0 && along < length * length) take(beyond, i, k);
        }
    }
}

}  // namespace detail

/// How far an outline is from the half-plane to the left of the line through two places: by the corner that is nearest,
/// or deepest in it.
inline Separation separation_from_half_plane(std::span<const Vector<double>> first, const Vector<double>& through,
                                             const Vector<double>& to) {
    Separation nearest;
    const Vector<double> along = to - through;
    const double length = std::hypot(along.x, along.y);
    for (std::size_t i = 0; i < first.size(); ++i)
        if (const double beyond = -cross(along, first[i] - through) / length; beyond < nearest.distance)
            nearest = {beyond, Separation::Of::side_of_second, i, 0};
    return nearest;
}

/// By separating axes where they overlap (the shortest way apart is across a side of one of them), else of the nearest
/// features (C. Ericson, Real-Time Collision Detection, Elsevier 2005, sections 5.1 and 5.2).
inline Separation separation(std::span<const Vector<double>> first, std::span<const Vector<double>> second) {
    using Of = Separation::Of;
    Separation deepest{-std::numeric_limits<double>::infinity()};
    detail::farthest_side(first, second, [&](double beyond, std::size_t i, std::size_t k) {
        if (beyond > deepest.distance) deepest = {beyond, Of::side_of_first, i, k};
    });
    detail::farthest_side(second, first, [&](double beyond, std::size_t i, std::size_t k) {
        if (beyond > deepest.distance) deepest = {beyond, Of::side_of_second, k, i};
    });
    const bool has_sides = first.size() > 1 || second.size() > 1;
    if (has_sides && deepest.distance < 0) return deepest;
    Separation nearest;
    for (std::size_t i = 0; i < first.size(); ++i)
        for (std::size_t k = 0; k < second.size(); ++k)
            if (const double d = std::hypot(second[k].x - first[i].x, second[k].y - first[i].y); d < nearest.distance)
                nearest = {d, Of::corners, i, k};
    detail::feet_on_sides(first, second, [&](double d, std::size_t i, std::size_t k) {
        if (d < nearest.distance) nearest = {d, Of::side_of_first, i, k};
    });
    detail::feet_on_sides(second, first, [&](double d, std::size_t i, std::size_t k) {
        if (d < nearest.distance) nearest = {d, Of::side_of_second, k, i};
    });
    return nearest;
}

}  // namespace mechwright
