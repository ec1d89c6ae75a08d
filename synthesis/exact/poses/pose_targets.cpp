#include "synthesis/exact/poses/pose_targets.h"

#include <cmath>

namespace mechwright {

PoseTargets pose_targets(const Problem& problem) {
    const PathTarget& path = *problem.path;
    const auto at = [&](std::size_t i) { return std::complex<double>(path.points[i].x, path.points[i].y); };
    const std::vector<double>& angles = path.prescribed_timing ? path.crank_angles : path.directions;
    PoseTargets g{&problem, {at(0), 1}, {}, {}};
    double sum = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        sum += std::norm(at(i) - at(0));
    // A power of two: scaling then costs no digits.
    if (sum > 0)
        g.place.size = std::exp2(std::round(std::log2(std::sqrt(sum / static_cast<double>(path.points.size())))));
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        g.displacements.push_back({(at(i) - at(0)) / g.place.size, std::polar(1.0, angles[i] - angles[0])});
        const Digits50 turned = Digits50(angles[i]) - angles[0];
        g.exact.push_back({{(Digits50(path.points[i].x) - path.points[0].x) / g.place.size,
                            (Digits50(path.points[i].y) - path.points[0].y) / g.place.size},
                           {cos(turned), sin(turned)}});
    }
    return g;
}

PivotRanges crank_pivot_ranges(const PoseTargets& g) {
    const Problem& problem = *g.problem;
    const PathRoles& roles = problem.mechanism->point->roles;
    const DimensionRange &x = problem.dimensions[roles.origin_x], &y = problem.dimensions[roles.origin_y];
    const double size = g.place.size;
    return {-g.place.origin / size, false, x.min / size, x.max / size, y.min / size, y.max / size};
}

}  // namespace mechwright
