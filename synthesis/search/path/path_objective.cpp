#include "synthesis/search/path/path_objective.h"

#include <algorithm>

namespace mechwright {

namespace {

/// The measure of the path, with all its targets, that is all that a problem minimises.
PathMeasure only_measure(const Problem& problem) {
    if (!problem.objective || problem.objective->terms.size() != 1) return PathMeasure::none;
    const ObjectiveTerm& term = problem.objective->terms.front();
    const Quantity& quantity = problem.mechanism->quantities[term.quantity];
    const bool of_all = quantity.of_target == every_target || (problem.path && problem.path->targets() == 1);
    return term.maximize || !of_all ? PathMeasure::none : quantity.path;
}

bool limits_path(const Problem& problem) {
    return std::any_of(problem.requirements.begin(), problem.requirements.end(), [&](const Requirement& r) {
        return problem.mechanism->quantities[r.quantity].path != PathMeasure::none;
    });
}

}  // namespace

bool least_squares_suffice(const Problem& problem) {
    const PathMeasure measure = only_measure(problem);
    return !limits_path(problem) &&
           (measure == PathMeasure::sum_of_squares || measure == PathMeasure::root_mean_square);
}

bool least_squares_lead_on(const Problem& problem) {
    return !limits_path(problem) && only_measure(problem) == PathMeasure::greatest;
}

}  // namespace mechwright
