#pragma once
/// \file
/// Four-bars whose velocity ratio has a given extreme value (Freudenstein's theorem): a family of two parameters.

#include <string>

#include "synthesis/exact/family_search.h"

namespace mechwright {

/// Whether a problem requires an extreme of the velocity ratio to equal a value.
bool requires_extreme_velocity_ratio(const Problem& problem);

/// Why the family does not cover a problem; empty if it does.
std::string why_no_extreme_velocity_ratio(const Problem& problem);
ExactDesigns extreme_velocity_ratio_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
