#pragma once
/// \file
/// Whether a design generates its function as an exact method says.

#include "synthesis/verify/rebuilt.h"

namespace mechwright {

/// The greatest error at the accuracy points of the function, which an exact method has met.
Check check_accuracy_points(const Rebuilt& design);

}  // namespace mechwright
