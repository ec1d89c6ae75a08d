#pragma once
/// \file
/// How a four-bar is drawn.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

Drawing four_bar_drawing();

}  // namespace mechwright
