#include "synthesis/search/path_objective.h"

#include <algorithm>

namespace mechwright {

namespace {

/// The measure of the path that is all that a problem minimises.
PathMeasure only_measure(const Problem& problem) {
    if (!problem.objective || problem.objective->terms.size() != 1) return PathMeasure::none;
    const ObjectiveTerm& term = problem.objective->terms.front();
    return term.maximize ? PathMeasure::none : problem.mechanism->quantities[term.quantity].path;
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
