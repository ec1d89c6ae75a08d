#pragma once
/// \file
/// The curves of a finished cam, in the cam's own plane as it lies at cam angle 0.

#include <functional>
#include <vector>

#include "analysis/geometry/arc_fit.h"
#include "synthesis/mechanism/drawing/moving_design.h"

namespace mechwright {

/// Radius of the roller, 0 of a knife edge or a flat face.
double roller_radius(const MovingDesign& cam);

/// Cam angles at which curves may have corners of their curvature: 0, ends of segments and of their pieces, a turn.
std::vector<double> cam_corners(const MovingDesign& cam);

/// The closed curve that lies so far outward from the profile, as arcs within a tolerance. At the roller's radius it is
/// the pitch curve.
std::vector<ArcVertex> cam_curve(const MovingDesign& cam, double offset, double tolerance);

}  // namespace mechwright
