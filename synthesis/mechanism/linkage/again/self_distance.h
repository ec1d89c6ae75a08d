#pragma once
/// \file
/// How near the path of a point comes to itself (rooms/approach.h), for verification: from samples of the poses.

#include "synthesis/mechanism/linkage/again/scan.h"

namespace mechwright::again {

/// The distance of a pin's path from itself, in the drawing's lengths. Not a number where the linkage has no poses.
Digits50 self_distance(const Scan& scan, std::size_t pin);

}  // namespace mechwright::again
