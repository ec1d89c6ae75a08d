#pragma once
/// \file
/// How the mechanisms that drive a ram are drawn. Those without a placement of their own lie in the frame of their
/// slide, the crank shaper turned so that its ram is above the lever's pivot.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

Drawing slider_crank_drawing();
Drawing crank_shaper_drawing();
Drawing whitworth_drawing();
Drawing drag_link_drawing();

}  // namespace mechwright
