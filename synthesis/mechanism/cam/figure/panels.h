#pragma once
/// \file
/// Panels of a cam's figure that are alike for several kinds of followers.

#include "synthesis/mechanism/drawing/figure.h"

namespace mechwright {

/// The lift over the cam angle, with what [[segment]] says of it. The design has a program of four segments.
FigurePanel cam_motion_panel(const MovingDesign& cam);

/// What holds a translating follower to its cam, at the lowest position.
FigurePanel cam_load_panel(const MovingDesign& cam);

}  // namespace mechwright
