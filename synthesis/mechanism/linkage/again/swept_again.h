#pragma once
/// \file
/// What the line between two points sweeps (rooms/swept), for verification: not by its outline but by parallel slices,
/// over each of which the places that the line passes are intervals. In doubles, to ten digits.

#include <span>

#include "synthesis/mechanism/linkage/again/scan.h"

namespace mechwright::again {

/// The area that the line between the two pins of a room sweeps, within a polygon where one is given. Not a number
/// where the linkage has no poses.
Digits50 swept_area(const Scan& scan, const LinkageRoom& room, std::span<const Vector<double>> within);

/// The area of the room's screen that it does not sweep.
Digits50 uncovered(const Scan& scan, const LinkageRoom& room);

}  // namespace mechwright::again
