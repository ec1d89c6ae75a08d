#pragma once
/// \file
/// Where the dimensions of a linkage are.

#include "synthesis/mechanism/drawing/figure.h"

namespace mechwright {

/// The links by their names, the points by theirs, and the dimensions that are a coordinate of a point on its link, or
/// its distance or direction there; what else they are is said below. Precondition: the design is of a linkage.
FigurePanel linkage_panel(const MovingDesign& design);

}  // namespace mechwright
