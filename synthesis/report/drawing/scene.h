#pragma once
/// \file
/// A mechanism as it is drawn: rigid bodies with their outlines, and where each of them is at a crank angle. Pictures,
/// drawings for CAD and the moving page are all made from this.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/report/drawing/finished.h"

namespace mechwright {

std::string_view name_of(Layer layer);

struct Scene {
    std::vector<Body> bodies;            ///< that move; the first one is driven
    std::vector<Outline> fixed;          ///< slides, paths, lines to be followed
    std::vector<Vector<double>> pivots;  ///< on the ground
    Body ground;               ///< names of its points and lines on which bodies stay; outlines are in `fixed`
    Vector<double> low, high;  ///< all that is passed in the motion lies between
    double symbol = 1;         ///< size of what has no size of its own, such as a ram

    double extent() const { return std::max(high.x - low.x, high.y - low.y); }
};

/// The bodies and curves of a design that assembles. Curves stay within `fineness` times the extent of the drawing.
Scene scene_of(const FinishedDesign& design, double fineness);

/// Where the bodies of the scene are, one place for each, with the given assembly. False where it does not assemble.
bool place_bodies(const FinishedDesign& design, double crank_angle, std::size_t assembly, std::span<BodyPlace> places);

/// Crank angles of the positions that limit the motion (Drawing::limits).
std::vector<double> limit_angles(const FinishedDesign& design);

/// Where the guided point of a scene is, the first where there are several; nothing where it has none.
std::optional<Vector<double>> guided_point(const FinishedDesign& design, const Scene& scene, double crank_angle);

}  // namespace mechwright
