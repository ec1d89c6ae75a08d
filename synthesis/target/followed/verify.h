#pragma once
/// \file
/// Whether a design follows its line or arc with a crank that turns fully, where it has to.

#include "synthesis/verify/rebuilt.h"

namespace mechwright {

Check check_full_turn(const Rebuilt& design);

}  // namespace mechwright
