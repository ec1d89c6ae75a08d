#include "synthesis/search/polished_search.h"

#include <cmath>

namespace mechwright {

namespace {

/// An objective below this is small against what the program was scaled for: tolerances then mean too little.
constexpr double small_objective = 1e-2;
/// Times that a search goes on in units of the objective reached, and the part by which that has to pay each time.
constexpr int most_magnifications = 4;
constexpr double pays_from = 1e-3;

/// A gradient that the active constraints balance to this part is that of an optimum.
constexpr double balanced_within = 1e-6;

bool asks_for_one_worst(const Program& program) {
    return program.epigraphs.size() == 1 && program.epigraphs.front().above && program.objective.outputs.empty();
}

bool is_feasible(const LocalOutcome& outcome) { return outcome.violation <= LocalOutcome::feasible_below; }

/// Of the extremes of an error the greatest changes from one to another, where the slope jumps: a method that ended at
/// such a place goes on to where the extremes are level.
LocalOutcome level_where_unbalanced(const Program& program, LocalOutcome outcome, const LocalLimits& limits) {
    if (!asks_for_one_worst(program) || !is_feasible(outcome)) return outcome;
    if (unbalanced_part(program, outcome.x) <= balanced_within) return outcome;
    const Eigen::VectorXd x = levelled(program, outcome.x, limits);
    ProgramValues values;
    evaluate(program, x, false, values);
    LocalOutcome level;
    level.consider(program, x, values);
    level = polish(program, level, limits);
    const bool lower = is_feasible(level) && level.objective < outcome.objective;
    level.evaluations += outcome.evaluations;
    level.hessians += outcome.hessians;
    if (lower) return level;
    outcome.evaluations = level.evaluations;
    outcome.hessians = level.hessians;
    return outcome;
}

}  // namespace

LocalOutcome polished_search(const Program& program, const Eigen::VectorXd& start, LocalMethod method,
                             const LocalLimits& limits) {
    LocalOutcome outcome =
        level_where_unbalanced(program, polish(program, method(program, start, limits), limits), limits);
    for (int pass = 0; pass < most_magnifications && !program.closest_to_reference; ++pass) {
        const double size = std::abs(outcome.objective);
        if (!is_feasible(outcome) || !(size > 0 && size < small_objective)) break;
        const Program great = magnified(program, size);
        Eigen::VectorXd x = outcome.x;
        settle_epigraphs(great, x);
        if (pass == 0 && asks_for_one_worst(great)) x = levelled(great, x, limits);
        LocalOutcome further = polish(great, method(great, x, limits), limits);
        outcome.evaluations += further.evaluations;
        outcome.hessians += further.hessians;
        if (!is_feasible(further) || !(further.objective * size < outcome.objective)) break;
        const bool pays = further.objective * size < outcome.objective - pays_from * size;
        outcome.x = std::move(further.x);
        outcome.objective = further.objective * size;
        settle_epigraphs(program, outcome.x);
        if (!pays) break;
    }
    return outcome;
}

}  // namespace mechwright
