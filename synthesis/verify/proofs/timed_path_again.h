#pragma once
/// \file
/// The least sum of squared distances from a timed path over all four-bars of given ratios, for verification.

#include "synthesis/verify/rebuilt.h"

namespace mechwright {

struct SearchedLinkages {
    double least = 0;  ///< weighted sum of squares of the best
    int linkages = 0;  ///< that were tried
};

/// Tries ratios of the links and starts of the crank that fill what there is evenly, then goes downhill from the best.
/// For each of them size, tilt, placement and guided point follow by linear least squares; those that are greater than
/// the document allows do not count. Of the assembly of the design.
SearchedLinkages search_timed_path(const Rebuilt& design);

}  // namespace mechwright
