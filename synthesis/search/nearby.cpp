#include "synthesis/search/nearby.h"

#include "synthesis/program/assess.h"
#include "synthesis/program/variant.h"

namespace mechwright {

namespace {

/// A gradient balanced to this part is balanced: what is left is rounding of the polish.
constexpr double balanced_within = 1e-6;

}  // namespace

NearbyOptimum nearby(const Problem& problem, const Design& from, const LocalLimits& limits) {
    NearbyOptimum best;
    for (const Variant& variant : variants(problem)) {
        if (variant.assembly != from.assembly || limits.reached()) continue;
        const Program program = build_program(problem, variant);
        const LocalOutcome outcome = polish(program, slsqp(program, point_of(program, from), limits), limits);
        best.evaluations += outcome.evaluations;
        if (outcome.x.size() == 0) continue;
        Solution found = assess(problem, design_at(program, outcome.x));
        if (!found.feasible || (best.solution && !preferred(problem, found, *best.solution))) continue;
        best.solution = std::move(found);
        best.stationary = !problem.objective || unbalanced_part(program, outcome.x) < balanced_within;
    }
    return best;
}

}  // namespace mechwright
