#pragma once
/// \file
/// A mechanism as it is drawn: rigid bodies with their outlines, and where each of them is at a crank angle. Pictures,
/// drawings for CAD and the moving page are all made from this.
///
/// The drawing's frame is that of the problem where the mechanism has a placement in it (four-bar, slider-crank). The
/// quick-return drives lie in the frame of their slide, the crank shaper turned so that its ram is above the lever's
/// pivot; cams have their centre at the origin.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/geometry/arc_fit.h"
#include "synthesis/report/drawing/finished.h"

namespace mechwright {

/// What a line of the drawing is; also the layers of a drawing for CAD.
enum class Layer { ground, link, block, cam, pitch, base, path, follow };

std::string_view name_of(Layer layer);

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
struct Place {
    Vector<double> at{};
    Vector<double> turn{1, 0};
};

struct Scene {
    std::vector<Body> bodies;            ///< that move; the first one is driven
    std::vector<Outline> fixed;          ///< slides, paths, lines to be followed
    std::vector<Vector<double>> pivots;  ///< on the ground
    Vector<double> low, high;            ///< all that is passed in the motion lies between
    double symbol = 1;                   ///< size of what has no size of its own, such as a ram

    double extent() const { return std::max(high.x - low.x, high.y - low.y); }
};

/// The bodies and curves of a design that assembles. Curves stay within `fineness` times the extent of the drawing.
Scene scene_of(const FinishedDesign& design, double fineness);

/// No scene has more bodies.
inline constexpr std::size_t most_bodies = 5;

/// Where the bodies of the scene are, one place for each, with the given assembly. False where it does not assemble.
bool place_bodies(const FinishedDesign& design, double crank_angle, std::size_t assembly, std::span<Place> places);

/// Crank angles of the positions in which the output turns back, or which limit the motion; for cams the ends of rises
/// and returns.
std::vector<double> limit_angles(const FinishedDesign& design);

/// Where the guided point of a scene is; nothing where it has none.
std::optional<Vector<double>> guided_point(const FinishedDesign& design, const Scene& scene, double crank_angle);

/// A point of a body's frame in the drawing.
inline Vector<double> in_drawing(const Place& place, const Vector<double>& point) {
    return place.at + turned(point, place.turn);
}

}  // namespace mechwright
