#pragma once
/// \file
/// Slider-cranks whose rod's point passes up to four points at given crank angles: their cranks are dyads
/// (timed_crank.h), and each makes poses of the rod, in four of which one point of it has its places on a line.

#include <string>

#include "synthesis/exact/family_search.h"

namespace mechwright {

/// Why a problem is not one of these; empty if it is.
std::string why_no_slider_crank_timed_points(const Problem& problem);
ExactDesigns slider_crank_timed_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
