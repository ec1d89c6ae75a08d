#pragma once
/// \file
/// Local searches from many starts over all variants of a problem, shared between threads; the distinct optima they end
/// at, and an estimate of what they have not seen.

#include "synthesis/local/local.h"
#include "synthesis/search/solve.h"

namespace mechwright {

struct Multistart {
    std::vector<Solution> optima;  ///< distinct, best first; infeasible ones after all feasible ones
    SearchReport report;
    bool stopped = false;  ///< by the time limit or from outside, before all starts were done
};

/// Runs at least `problem.solver.starts` local searches with the method, each polished. The result is the same for any
/// number of jobs.
Multistart multistart(const Problem& problem, LocalMethod method, const RunOptions& options,
                      std::chrono::steady_clock::time_point deadline);

}  // namespace mechwright
