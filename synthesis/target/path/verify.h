#pragma once
/// \file
/// Checks of what a result says of its coupler path.

#include <vector>

#include "synthesis/verify/rebuilt.h"
#include "synthesis/verify/verify.h"

namespace mechwright {

/// Reached points and distances (where everything is stated), timing or order, and that one assembled branch holds all
/// the points. The design's claim must have a path.
std::vector<Check> check_path(const Rebuilt& design, Stated parts);

}  // namespace mechwright
