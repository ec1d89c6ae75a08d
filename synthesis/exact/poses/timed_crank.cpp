#include "synthesis/exact/poses/timed_crank.h"

#include <cmath>

namespace mechwright {

TimedCrank timed_crank(const PoseTargets& g, const Dyad& seen) {
    TimedCrank crank{{seen.fixed, seen.fixed - seen.moving}, {}};
    const std::complex<double> first = seen.moving - seen.fixed;  // from the pin to the point
    for (const auto& [shift, turn] : g.displacements) {
        const std::complex<double> now = shift - seen.fixed + seen.moving * turn;
        const std::complex<double> coupler_turn = now / first;
        crank.displacements.push_back({shift, coupler_turn / std::abs(coupler_turn)});
    }
    return crank;
}

std::optional<DyadCondition> line_of_crank_pin(const PoseTargets& g) {
    const Problem& problem = *g.problem;
    const PathRoles& roles = problem.mechanism->point->roles;
    const DimensionRange &start = problem.dimensions[roles.start], &tilt = problem.dimensions[roles.tilt];
    if (!start.fixed() || !tilt.fixed()) return {};
    return moving_pivot_on_line(0, std::polar(1.0, tilt.min + start.min + problem.path->crank_angles.front()));
}

}  // namespace mechwright
