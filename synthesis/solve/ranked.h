#pragma once
/// \file
/// Wishes in order: an objective is met as well as can be, or within what is allowed, then the next among what remains.

#include "synthesis/program/run_options.h"
#include "synthesis/solve/choose.h"

namespace mechwright {

/// Solves for each wish in turn, then for the objective, each time under the limits of those before: the best value
/// that was found, or worse by what the wish allows, but at least by a millionth of it and, of a length, by 1e-9 of the
/// longest dimension, so that there is room to search in. Only designs that pass verification count as the best of a
/// wish. Precondition: there is a wish, and an objective.
Found ranked_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
