#pragma once
/// \file
/// Lines and arcs that bodies are drawn with.

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "synthesis/mechanism/drawing/body.h"

namespace mechwright::outlines {

inline Outline segment(const Vector<double>& a, const Vector<double>& b, Layer layer = Layer::link) {
    return {layer, {{a, 0}, {b, 0}}, false};
}

inline Outline polygon(std::initializer_list<Vector<double>> corners, Layer layer = Layer::link) {
    Outline outline{layer, {}, true};
    for (const Vector<double>& corner : corners)
        outline.vertices.push_back({corner, 0});
    return outline;
}

/// In four quarters, so that the vertices show how far it reaches.
inline Outline circle(const Vector<double>& centre, double radius, Layer layer) {
    const double quarter = std::tan(std::numbers::pi / 8);
    Outline outline{layer, {}, true};
    for (const Vector<double>& side : {Vector<double>{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
        outline.vertices.push_back({centre + radius * side, quarter});
    return outline;
}

/// Radius of an outline that `circle` made; absent for others.
inline std::optional<double> radius_of(const Outline& outline) {
    const std::vector<ArcVertex>& v = outline.vertices;
    if (!outline.closed || v.size() != 4) return {};
    for (const ArcVertex& vertex : v)
        if (vertex.bulge != std::tan(std::numbers::pi / 8)) return {};
    const Vector<double> across = v[2].at - v[0].at;
    return 0.5 * std::hypot(across.x, across.y);
}

/// What is at most `half_width` from a segment.
inline Outline slot(const Vector<double>& a, const Vector<double>& b, double half_width, Layer layer) {
    const Vector<double> along = b - a;
    const double length = std::hypot(along.x, along.y);
    const Vector<double> side = length > 0 ? (half_width / length) * left_of(along) : Vector<double>{0, half_width};
    return {layer, {{a - side, 0}, {b - side, 1}, {b + side, 0}, {a + side, 1}}, true};
}

/// What is at most `half_width` from an arc about a centre, from one angle to a greater one; two circles, an outline
/// each, where that is a full turn.
inline std::vector<Outline> arc_slot(const Vector<double>& centre, double radius, double from, double to,
                                     double half_width, Layer layer) {
    if (to - from >= 2 * std::numbers::pi)
        return {circle(centre, radius + half_width, layer), circle(centre, radius - half_width, layer)};
    const auto at = [&](double angle, double length) {
        return centre + length * Vector<double>{std::cos(angle), std::sin(angle)};
    };
    // In pieces, so that the vertices show how far it reaches.
    const int pieces = 1 + static_cast<int>((to - from) / 0.5);
    const double bulge = std::tan(0.25 * (to - from) / pieces), step = (to - from) / pieces;
    Outline outline{layer, {}, true};
    for (int i = 0; i <= pieces; ++i)
        outline.vertices.push_back({at(from + i * step, radius + half_width), i < pieces ? bulge : 1});
    for (int i = pieces; i >= 0; --i)
        outline.vertices.push_back({at(from + i * step, radius - half_width), i > 0 ? -bulge : 1});
    return {outline};
}

inline Outline rectangle(double half_length, double half_height, Layer layer) {
    return polygon({{-half_length, -half_height},
                    {half_length, -half_height},
                    {half_length, half_height},
                    {-half_length, half_height}},
                   layer);
}

/// From a point in a direction (unit vector), with a head.
inline Outline arrow(const Vector<double>& from, const Vector<double>& direction, double length, Layer layer) {
    const Vector<double> tip = from + length * direction, side = 0.12 * length * left_of(direction);
    const Vector<double> neck = from + 0.75 * length * direction;
    return {layer, {{from, 0}, {tip, 0}, {neck + side, 0}, {tip, 0}, {neck - side, 0}}, false};
}

}  // namespace mechwright::outlines
