#pragma once
/// \file
/// Boxes and margins of regions for verification: of all points of every pose at once, along the motion as it is
/// sampled.

#include "synthesis/mechanism/linkage/again/scan.h"
#include "synthesis/mechanism/linkage/quantities.h"

namespace mechwright::again {

/// Whether a quantity is of a room or a region.
bool is_of_place(const LinkageMeasure& measure);

/// Such a quantity, in lengths or areas of the file.
Digits50 of_place(const Scan& scan, const LinkageMeasure& measure);

}  // namespace mechwright::again
