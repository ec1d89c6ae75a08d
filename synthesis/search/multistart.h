#pragma once
/// \file
/// Local searches from many starts over all variants of a problem, shared between threads; the distinct optima they end
/// at, and an estimate of what they have not seen.

#include <optional>
#include <vector>

#include "synthesis/local/local.h"
#include "synthesis/program/run_options.h"

namespace mechwright {

/// How far a search had come, and with how much work.
struct Milestone {
    long screened = 0;     ///< candidates ranked to find starts
    long evaluations = 0;  ///< of local searches
    long hessians = 0;
    std::optional<Solution> best;
};

struct Multistart {
    std::vector<Solution> optima;  ///< distinct, best first; infeasible ones after all feasible ones
    SearchReport report;
    std::vector<Milestone> milestones;  ///< after each start, or each round of starts, in their order
    bool stopped = false;               ///< by the time limit or from outside, before all starts were done
};

/// Runs at least `problem.solver.starts` local searches with the method, each polished. The result is the same for any
/// number of jobs.
Multistart multistart(const Problem& problem, LocalMethod method, const RunOptions& options,
                      std::chrono::steady_clock::time_point deadline);

}  // namespace mechwright
