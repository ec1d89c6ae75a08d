#pragma once
/// \file
/// Margins of regions for verification: of all points of every pose at once, overlaps by all pairs of points.

#include "synthesis/mechanism/linkage/again/scan.h"
#include "synthesis/mechanism/linkage/quantities.h"

namespace mechwright::again {

/// The least over the motion, in lengths of the file: negative where something is on the wrong side of a border.
Digits50 margin_of_region(const Scan& scan, const LinkageRegion& region);

}  // namespace mechwright::again
