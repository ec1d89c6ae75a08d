#pragma once
/// \file
/// Rigid bodies as they are drawn, and where they are.

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/geometry/arc_fit.h"

namespace mechwright {

/// What a line of the drawing is; also the layers of a drawing for CAD.
enum class Layer { ground, link, block, cam, pitch, base, path, follow, room };

/// Lines and arcs one after the other.
struct Outline {
    Layer layer = Layer::link;
    std::vector<ArcVertex> vertices;
    bool closed = false;
};

/// A name that stands beside a place.
struct Label {
    std::string text;
    Vector<double> at;
};

/// In place of the number of a body: what does not move.
inline constexpr std::size_t the_ground = static_cast<std::size_t>(-1);

/// A straight line of a body on which points of another one stay; two of a body that does not turn on it.
struct Guide {
    Vector<double> from, to;             ///< beyond all that they pass
    std::size_t body;                    ///< whose points they are
    std::vector<Vector<double>> points;  ///< in that one's frame
};

/// Something rigid. What it consists of is in its own frame.
struct Body {
    std::string name;
    std::vector<Outline> outlines;
    std::vector<Vector<double>> pins;
    std::vector<Vector<double>> points;  ///< that guide something
    std::vector<Label> labels{};         ///< names of these, where they have some
    std::vector<Guide> guides{};
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
