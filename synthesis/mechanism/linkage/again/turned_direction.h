#pragma once
/// \file
/// The direction in which a box about parts of a linkage is least, for verification: by a scan of all directions.

#include "synthesis/mechanism/linkage/again/scan.h"
#include "synthesis/mechanism/linkage/quantities.h"

namespace mechwright::again {

/// The direction of its width in radians, of a room whose width or area is to be least.
double turned_direction(const Scan& scan, const LinkageRoom& room);

}  // namespace mechwright::again
