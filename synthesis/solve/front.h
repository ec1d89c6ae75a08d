#pragma once
/// \file
/// The trade-off between two objectives.

#include <chrono>
#include <vector>

#include "synthesis/program/run_options.h"

namespace mechwright {

/// Designs of a problem with two objectives none of which is as good in both as another within the problem's
/// tolerance, at most `problem.solver.pareto` of them, in order from the best in the first objective to the best in the
/// second. Between the two best designs of one objective (and, of those that are equally good, of the other), one
/// objective is optimised under evenly spaced limits on the other (the epsilon-constraint method of Haimes, Lasdon and
/// Wismer), each time by a search of its own and from the neighbours on the front. Only verified designs are returned.
/// `best` is the objective of the problem's own best design, for whoever watches.
std::vector<VerifiedDesign> front(const Problem& problem, const RunOptions& options,
                                  std::chrono::steady_clock::time_point deadline, double best);

}  // namespace mechwright
