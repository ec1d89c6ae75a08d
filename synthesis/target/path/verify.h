#pragma once
/// \file
/// Checks of what a result says of its coupler path.

#include <vector>

#include "synthesis/verify/rebuilt.h"
#include "synthesis/verify/verify.h"

namespace mechwright {

/// The range of use between the stated crank angles of the targets, radians, by another way than the optimiser's; from
/// > to where these are not stated. The claim must have a range of use and a path.
std::optional<Vector<Digits50>> range_of_use_again(const Rebuilt& design);

/// Whether the range of use is stated as it follows from the stated crank angles.
Check check_range_of_use(const Rebuilt& design, Stated parts);

/// Reached points and distances (where everything is stated), timing or order, and that one assembled branch holds all
/// the points. The design's claim must have a path.
std::vector<Check> check_path(const Rebuilt& design, Stated parts);

}  // namespace mechwright
