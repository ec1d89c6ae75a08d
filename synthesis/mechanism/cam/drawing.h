#pragma once
/// \file
/// How a cam and its follower are drawn: the cam's centre is the origin.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

Drawing cam_drawing();

}  // namespace mechwright
