#include "synthesis/report/drawing/figure/places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "synthesis/mechanism/drawing/outlines.h"

namespace mechwright {

namespace {

/// The line or the arc that is to be followed.
const std::vector<ArcVertex>& followed_outline(const Scene& scene) {
    return std::find_if(scene.fixed.begin(), scene.fixed.end(),
                        [](const Outline& outline) { return outline.layer == Layer::follow; })
        ->vertices;
}

Vector<double> nearest_to_origin(const Vector<double>& a, const Vector<double>& b) {
    const Vector<double> along = b - a;
    return a - (dot(a, along) / dot(along, along)) * along;
}

/// The centre of the circle through three places.
Vector<double> centre_through(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c) {
    const Vector<double> p = b - a, q = c - a;
    const double twice = 2 * cross(p, q);
    return a + (1 / twice) * Vector<double>{q.y * dot(p, p) - p.y * dot(q, q), p.x * dot(q, q) - q.x * dot(p, p)};
}

}  // namespace

Vector<double> PosedPanel::at(const FigurePlace& place) const {
    std::size_t b = 0;
    while (b < scene.bodies.size() && scene.bodies[b].name != place.body)
        ++b;
    if (!place.body.empty() && b == scene.bodies.size()) throw std::logic_error("a figure has no body " + place.body);
    const auto on_body = [&](const Vector<double>& own) {
        return in_drawing((place.at_end ? end_places : places)[b], own);
    };
    switch (place.of) {
        case PlaceOf::pin: return on_body(scene.bodies[b].pins.at(place.number));
        case PlaceOf::point: return on_body(scene.bodies[b].points.at(place.number));
        case PlaceOf::corner: return on_body(scene.bodies[b].outlines.at(place.number).vertices.at(place.corner).at);
        case PlaceOf::pivot: return scene.pivots.at(place.number);
        case PlaceOf::fixed: return place.body.empty() ? place.at : on_body(place.at);
        case PlaceOf::line_foot:
            return nearest_to_origin(followed_outline(scene).front().at, followed_outline(scene).back().at);
        case PlaceOf::line_end:
        case PlaceOf::arc_end: return followed_outline(scene).back().at;
        case PlaceOf::arc_centre: break;
    }
    const std::vector<ArcVertex>& arc = followed_outline(scene);
    return centre_through(arc.front().at, arc[arc.size() / 2].at, arc.back().at);
}

Vector<double> PosedPanel::at(std::string_view name) const {
    for (const FigurePlace& place : panel.places)
        if (place.name == name) return at(place);
    throw std::logic_error("a figure has no place " + std::string(name));
}

Vector<double> PosedPanel::direction(const FigureSide& side) const {
    Vector<double> along{1, 0};
    if (!side.from.empty()) along = at(side.to) - at(side.from);
    const double turned_by = side.turned * std::numbers::pi / 180;
    return turned((1 / std::hypot(along.x, along.y)) * along, {std::cos(turned_by), std::sin(turned_by)});
}

}  // namespace mechwright
