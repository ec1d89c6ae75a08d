#pragma once
/// \file
/// Every dyad behind a linkage, from a pin of it to the output, that meets a function at two to five accuracy points.

#include <string>

#include "synthesis/exact/family_search.h"

namespace mechwright {

/// Why the accuracy points of a problem with a linkage do not say the dyad that ends on its output; empty if they do.
std::string why_no_output_points(const Problem& problem);

/// Precondition: why_no_output_points is empty.
ExactDesigns output_point_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
