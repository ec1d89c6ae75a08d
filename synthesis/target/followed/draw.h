#pragma once
/// \file
/// The line or the arc that a guided point follows, in drawings and plots.

#include "synthesis/report/drawing/scene.h"

namespace mechwright {

/// Adds the line, or the arc, beside where the guided point is over the input range; nothing where none is followed.
void add_followed(const FinishedDesign& design, Scene& scene);

/// How far the guided point is from it at a crank angle: from a line positive to its left, from an arc outside.
double distance_from_followed(const FinishedDesign& design, double crank_angle);

}  // namespace mechwright
