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
    LocalOutcome best;
    best.x = start;
    LocalLimits few = limits;
    few.most_evaluations = most_evaluations;
    for (int time = 0; time < most_times && !limits.reached(); ++time) {
        const std::optional<Program> beside = met_along_normals(program, best.x);
        if (!beside) return std::nullopt;
        LocalOutcome next = ipopt(*beside, best.x, few);
        next.evaluations += best.evaluations;
        next.hessians += best.hessians;
        if (next.violation > LocalOutcome::feasible_below) return std::nullopt;
        const bool gains = time == 0 || next.objective < best.objective - gains_from * std::abs(best.objective);
        if (time == 0 || next.objective < best.objective) best = next;
        best.evaluations = next.evaluations;
        best.hessians = next.hessians;
        if (!gains) break;
        few.near_optimum = true;
    }
    const LocalOutcome work = best;
    ProgramValues values;
    evaluate(program, work.x, false, values);
    best = {};
    best.consider(program, work.x, values);
    best.evaluations += work.evaluations;
    best.hessians = work.hessians;
    return best;
}

}  // namespace mechwright
