#include "synthesis/search/limited_distances.h"

#include <cmath>

namespace mechwright {

namespace {

/// Of one set of normals: some dozens suffice where a search gets anywhere.
constexpr int most_evaluations = 150;
/// Times that the normals are taken; and the part that has to be gained for another time.
constexpr int most_times = 8;
constexpr double gains_from = 1e-9;

}  // namespace

std::optional<LocalOutcome> within_limited_distances(const Program& program, const Eigen::VectorXd& start,
                                                     const LocalLimits& limits) {
    if (limits.reached()) return std::nullopt;
    LocalOutcome outcome;
    Eigen::VectorXd x = start;
    double objective = unlimited;
    LocalLimits few = limits;
    few.most_evaluations = most_evaluations;
    for (int time = 0; time < most_times && !limits.reached(); ++time) {
        const std::optional<Program> beside = met_along_normals(program, x);
        if (!beside) return std::nullopt;
        const LocalOutcome next = ipopt(*beside, x, few);
        outcome.evaluations += next.evaluations;
        outcome.hessians += next.hessians;
        outcome.verdict = next.verdict;
        if (next.violation > LocalOutcome::feasible_below) return std::nullopt;
        const bool gains = time == 0 || next.objective < objective - gains_from * std::abs(objective);
        if (time == 0 || next.objective < objective) {
            x = next.x;
            objective = next.objective;
        }
        if (!gains) break;
        few.near_optimum = true;
    }
    ProgramValues values;
    evaluate(program, x, false, values);
    outcome.consider(program, x, values);
    return outcome;
}

}  // namespace mechwright
