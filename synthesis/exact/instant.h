#pragma once
/// \file
/// The four-bar whose links have given angular velocities and accelerations at one instant (Rosenauer).

#include <string>

#include "synthesis/exact/exact_designs.h"
#include "synthesis/program/run_end.h"
#include "synthesis/program/run_options.h"

namespace mechwright {

/// Why a problem is not Rosenauer's; empty if it is.
std::string why_no_instant(const Problem& problem);
ExactDesigns instant_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
