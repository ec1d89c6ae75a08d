#pragma once
/// \file
/// Every four-bar that passes given places in their order: nine points, or poses among points, each pose in the place
/// of two points but for the first, which takes that of one; or fewer, which a family of four-bars passes. Likewise
/// every slider-crank, through eight.

#include <string>

#include "synthesis/exact/exact_designs.h"
#include "synthesis/program/run_end.h"
#include "synthesis/program/run_options.h"

namespace mechwright {

/// Why a problem has not the places of one of these systems; empty if it has.
std::string why_no_places(const Problem& problem);

/// With fewer places the best members of the family. Else all real solutions, each with its cognates where there are
/// points alone, and either fixed pivot as that of the crank, sized and placed as the targets say. Precondition:
/// why_no_places is empty.
ExactDesigns place_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
