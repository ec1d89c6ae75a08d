#include "synthesis/search/polished_search.h"

#include <cmath>
#include <optional>

#include "synthesis/program/search_trace.h"
#include "synthesis/search/limited_distances.h"

namespace mechwright {

namespace {

/// An objective below this is small against what the program was scaled for: tolerances then mean too little.
constexpr double small_objective = 1e-2;
/// Times that a search goes on in units of the objective reached, and the part by which that has to pay each time.
constexpr int most_magnifications = 4;
constexpr double pays_from = 1e-3;

/// From the end of another method to where the worst are level takes some dozens, in long valleys a thousand.
constexpr int evaluations_to_level = 4000;

bool is_feasible(const LocalOutcome& outcome) { return outcome.violation <= LocalOutcome::feasible_below; }

/// Of what a worst is the worst of, the one that counts changes from one to another, where the slope jumps: a method
/// that ended at such a place goes on to where they are level.
LocalOutcome levelled(const Program& program, LocalOutcome outcome, const LocalLimits& limits) {
    const double size = std::abs(outcome.objective);
    if (!asks_for_one_worst(program) || !is_feasible(outcome) || !(size > 0)) return outcome;
    const Program magnified_program = magnified(program, size);
    Eigen::VectorXd x = outcome.x;
    settle_epigraphs(magnified_program, x);
    if (unbalanced_part(magnified_program, x) <= balanced_within) return outcome;
    LocalLimits enough = limits;
    enough.most_evaluations = evaluations_to_level;
    const LocalOutcome level = polish(magnified_program, minimax(magnified_program, x, enough), limits);
    outcome.evaluations += level.evaluations;
    outcome.hessians += level.hessians;
    if (!is_feasible(level) || !(level.objective * size < outcome.objective)) return outcome;
    outcome.x = level.x;
    outcome.objective = level.objective * size;
    outcome.violation = level.violation;
    settle_epigraphs(program, outcome.x);
    return outcome;
}

LocalOutcome searched(const Program& program, const Eigen::VectorXd& start, LocalMethod method,
                      const LocalLimits& limits) {
    const auto close = limits.near_optimum ? std::nullopt : within_limited_distances(program, start, limits);
    return close ? *close : method(program, start, limits);
}

}  // namespace

LocalOutcome polished_search(const Program& program, const Eigen::VectorXd& start, LocalMethod method,
                             const LocalLimits& limits) {
    const LocalOutcome end = searched(program, start, method, limits);
    const Timed timed(limits.polishing);
    LocalOutcome outcome = levelled(program, polish(program, end, limits), limits);
    if (asks_for_one_worst(program)) return outcome;
    LocalLimits near = limits;
    near.near_optimum = true;
    for (int pass = 0; pass < most_magnifications && !program.closest_to_reference; ++pass) {
        const double size = std::abs(outcome.objective);
        if (!is_feasible(outcome) || !(size > 0 && size < small_objective)) break;
        const Program magnified_program = magnified(program, size);
        Eigen::VectorXd x = outcome.x;
        settle_epigraphs(magnified_program, x);
        const LocalOutcome further = polish(magnified_program, method(magnified_program, x, near), limits);
        outcome.evaluations += further.evaluations;
        outcome.hessians += further.hessians;
        if (!is_feasible(further) || !(further.objective * size < outcome.objective)) break;
        const bool pays = further.objective * size < outcome.objective - pays_from * size;
        outcome.x = further.x;
        outcome.objective = further.objective * size;
        settle_epigraphs(program, outcome.x);
        if (!pays) break;
    }
    return outcome;
}

}  // namespace mechwright
