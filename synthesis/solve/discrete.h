#pragma once
/// \file
/// Problems in which some dimensions have a few allowed values: branch and bound over the same problem with whole
/// ranges.

#include "synthesis/program/run_options.h"
#include "synthesis/solve/choose.h"

namespace mechwright {

/// Designs whose dimensions all have allowed values, the best first. Each problem whose dimensions may have any value
/// of a part of their ranges is solved by the method that it asks for; where its best design has other values, the part
/// is split between the allowed values beside one of them, and parts that promise least are left for last. What cannot
/// beat a design that was found is not split: SearchReport::discrete says what is then left. Precondition: some
/// dimension is discrete.
Found discrete_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
