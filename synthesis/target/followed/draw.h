#pragma once
/// \file
/// The line or the arc that a guided point follows, in drawings and plots.

#include "synthesis/problem/input_tasks.h"
#include "synthesis/report/drawing/scene.h"

namespace mechwright {

/// Adds all lines and arcs, each beside where its guided point is over the input range.
void add_followed(const FinishedDesign& design, Scene& scene);

/// How far the guided point is from one at a crank angle: from a line positive to its left, from an arc outside.
double distance_from_followed(const FinishedDesign& design, const InputTask& task, double crank_angle);

}  // namespace mechwright
