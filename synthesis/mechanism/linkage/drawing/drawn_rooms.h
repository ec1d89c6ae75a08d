#pragma once
/// \file
/// Boxes that parts of a linkage need over the motion, and regions that they keep in or out of, as they are drawn.

#include "synthesis/mechanism/drawing/body.h"
#include "synthesis/mechanism/drawing/moving_design.h"

namespace mechwright {

/// As Drawing::rooms, with their names, in the drawing's axes. A half-plane is its border, a little longer than what
/// keeps to it. The model of the design's motion is a LinkageModel.
void draw_rooms(const MovingDesign& design, Body& ground);

}  // namespace mechwright
