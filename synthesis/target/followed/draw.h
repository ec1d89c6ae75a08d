#pragma once
/// \file
/// The line or the arc that a guided point follows, in drawings and plots.

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/report/drawing/scene.h"

namespace mechwright {

/// Adds the line, or the arc, beside where the guided point is over the input range; nothing where none is followed.
void add_followed(const FinishedDesign& design, Scene& scene);

/// How far the guided point is from it in a row of the motion: from a line positive to its left, from an arc outside.
double distance_from_followed(const FinishedDesign& design, const MotionRow& row);

}  // namespace mechwright
