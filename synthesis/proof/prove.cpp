#include "synthesis/proof/prove.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "synthesis/mechanism/four_bar/timed_path_bound.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/proof/branch_and_bound.h"

namespace mechwright {

namespace {

/// The bound is raised to this part below the design's own value, and no further.
constexpr double closed_within = 1e-6;

}  // namespace

std::string why_no_proof(const Problem& problem) { return four_bar::TimedPathBound::why_not(problem); }

bool prove(const Problem& problem, const Solution& best, SearchReport& report, const RunOptions& options,
           std::chrono::steady_clock::time_point deadline) {
    const four_bar::TimedPathBound bound(problem);
    const double sum = path_values(problem, best.design)->sum_of_squares;
    const LowerBound found = lower_bound(bound.boxes(), bound, (1 - closed_within) * sum, options, deadline);
    const Quantity& q = problem.mechanism->quantities[problem.objective->terms.front().quantity];
    const double weights = std::accumulate(problem.path->weights.begin(), problem.path->weights.end(), 0.0);
    report.bound = q.path == PathMeasure::sum_of_squares ? found.least : std::sqrt(found.least / weights);
    report.boxes = found.boxes;
    if (!found.reached) return false;
    report.complete = true;
    report.missed_chance = 0;
    report.argument = fmt::format("branch and bound over the ratios of the links, {} boxes: no design is better by a "
                                  "millionth",
                                  found.boxes);
    return true;
}

}  // namespace mechwright
