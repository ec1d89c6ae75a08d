#pragma once
/// \file
/// A mechanism and its motion as JSON for other programs.

#include "synthesis/report/drawing/scene.h"

namespace mechwright {

/// {units, mechanism, bodies: [{name, pins, points, outlines: [{layer, closed, vertices: [[x, y, bulge]]}]}], pivots,
/// fixed: [outlines], targets: [{at, [direction], [reached]}], motion: {angles, places: [[x, y, angle] by body] by
/// angle}}. Bodies are in their own frames; `places` says where those are at `steps` + 1 even crank angles, null where
/// the mechanism does not assemble. A bulge is the tangent of a quarter of the arc to the next vertex, 0 for a line.
nlohmann::ordered_json motion_json(const FinishedDesign& design, const Scene& scene, int steps);

}  // namespace mechwright
