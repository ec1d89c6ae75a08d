#pragma once
/// \file
/// Rigid bodies as they are drawn, and where they are.

#include <string>
#include <vector>

#include "analysis/geometry/arc_fit.h"

namespace mechwright {

/// What a line of the drawing is; also the layers of a drawing for CAD.
enum class Layer { ground, link, block, cam, pitch, base, path, follow };

/// Lines and arcs one after the other.
struct Outline {
    Layer layer = Layer::link;
    std::vector<ArcVertex> vertices;
    bool closed = false;
};

/// Something rigid. Its outlines and pins are in its own frame, whose origin is its first pin.
struct Body {
    std::string name;
    std::vector<Outline> outlines;
    std::vector<Vector<double>> pins;
    std::vector<Vector<double>> points;  ///< that guide something
};

/// Where a body's frame is: its origin, and the unit vector of its x axis.
struct BodyPlace {
    Vector<double> at{};
    Vector<double> turn{1, 0};
};

/// A point of a body's frame in the drawing.
inline Vector<double> in_drawing(const BodyPlace& place, const Vector<double>& point) {
    return place.at + turned(point, place.turn);
}

}  // namespace mechwright
