#pragma once
/// \file
/// The instant centres of a linkage in the drawing.

#include <optional>
#include <span>
#include <vector>

#include "analysis/linkage/measuring/instant_centres.h"
#include "synthesis/mechanism/linkage/model.h"

namespace mechwright {

/// Those of all pairs of links at an input of the master; what stands for a circular slot is none of the links. Absent
/// where the linkage does not close, or has a dyad at its limit, where links are infinitely fast.
std::optional<std::vector<linkage::InstantCentre>> centres_in_drawing(const LinkageModel& model,
                                                                      std::span<const double> dimensions,
                                                                      std::size_t assembly, double master);

}  // namespace mechwright
