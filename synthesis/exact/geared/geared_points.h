#pragma once
/// \file
/// Geared five-bars whose common pin passes two to five points at given crank angles (geared_five_bar.h).

#include <string>

#include "synthesis/exact/exact_designs.h"
#include "synthesis/program/run_end.h"
#include "synthesis/program/run_options.h"

namespace mechwright {

/// Why a problem of a geared five-bar is not one of these; empty if it is.
std::string why_no_geared_timed_points(const Problem& problem);

/// All of them through five points, the best of the family that is found through fewer.
ExactDesigns geared_timed_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
