#include "synthesis/exact/known_solutions.h"

#include <algorithm>

#include "synthesis/exact/homotopy/guidance_start.h"
#include "synthesis/exact/place_family.h"

namespace mechwright {

std::optional<std::size_t> known_solutions(const Problem& problem) {
    if (!problem.path || !second_dyad(problem)) return {};
    const PathTarget& path = *problem.path;
    const std::size_t poses = std::max<std::size_t>(path.poses(), 1);
    const bool is_one = !path.prescribed_timing && !path.any_order && path.points.size() > poses &&
                        conditions_said_by(path) == conditions_of(problem);
    if (!is_one) return {};
    return homotopy::orbits_of({poses, *second_dyad(problem)});
}

}  // namespace mechwright
