#pragma once
/// \file
/// Exact synthesis as a method: every mechanism that meets its targets exactly, where there are finitely many; the best
/// that were found of a family, where there are not.

#include <string>

#include "synthesis/exact/exact_designs.h"
#include "synthesis/program/run_end.h"
#include "synthesis/program/run_options.h"

namespace mechwright {

/// Why exact synthesis does not cover a problem; empty if it does.
std::string why_not_exact(const Problem& problem);

/// Precondition: why_not_exact is empty. Where `end` is reached before, what was found until then.
ExactDesigns exact_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
