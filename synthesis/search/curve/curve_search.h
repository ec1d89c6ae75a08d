#pragma once
/// \file
/// The search for paths in any order by whole curves (curve/batch.h): batches that know nothing of each other, then
/// variations of the best that they came to, then sequential quadratic programming.

#include "synthesis/search/multistart.h"

namespace mechwright {

/// Whether a problem can be searched so: a path in any order whose least squares are the objective, or whose greatest
/// distance is, to which they lead (curve_problem says what else).
bool can_search_curves(const Problem& problem);

/// Runs batches, some at a time, until the points are met exactly, or hardly any batch would end where none has yet, or
/// there were as many as the problem's number of starts allows. The chance that a better design was missed is the share
/// of batches expected to end where none has. The result is the same for any number of jobs.
Multistart curve_search(const Problem& problem, const RunOptions& options,
                        std::chrono::steady_clock::time_point deadline);

}  // namespace mechwright
