#pragma once
/// \file
/// Every four-bar whose rocker angle meets a function at three, four or five accuracy points.

#include <string>

#include "synthesis/exact/family_search.h"

namespace mechwright {

/// Why a problem is not one of accuracy points; empty if it is.
std::string why_no_accuracy_points(const Problem& problem);
ExactDesigns accuracy_point_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
