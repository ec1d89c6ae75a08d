#include "synthesis/exact/poses/pose_targets.h"

#include <cmath>

#include "synthesis/exact/guided_parts.h"

namespace mechwright {

namespace {

/// The angles by which the body, or the crank, has turned at the points of a problem.
const std::vector<double>& angles_of(const Problem& problem) {
    const PathTarget& path = *problem.path;
    return path.prescribed_timing ? path.crank_angles : path.directions;
}

}  // namespace

PoseTargets pose_targets(const Problem& problem) { return pose_targets(problem, angles_of(problem)); }

PoseTargets pose_targets(const Problem& problem, const std::vector<double>& directions) {
    const std::vector<Vector<double>>& points = problem.path->points;
    const auto at = [&](std::size_t i) { return std::complex<double>(points[i].x, points[i].y); };
    PoseTargets g{&problem, {at(0), 1}, {}};
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        sum += std::norm(at(i) - at(0));
    // A power of two: scaling then costs no digits.
    if (sum > 0) g.place.size = std::exp2(std::round(std::log2(std::sqrt(sum / static_cast<double>(points.size())))));
    for (std::size_t i = 1; i < points.size(); ++i)
        g.displacements.push_back({(at(i) - at(0)) / g.place.size, std::polar(1.0, directions[i] - directions[0])});
    return g;
}

std::vector<ExactDisplacement> exact_displacements(const PoseTargets& g) {
    const std::vector<Vector<double>>& points = g.problem->path->points;
    const std::vector<double>& angles = angles_of(*g.problem);
    std::vector<ExactDisplacement> exact;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Digits50 turned = Digits50(angles[i]) - angles[0];
        exact.push_back({{(Digits50(points[i].x) - points[0].x) / g.place.size,
                          (Digits50(points[i].y) - points[0].y) / g.place.size},
                         {cos(turned), sin(turned)}});
    }
    return exact;
}

PivotRanges crank_pivot_ranges(const PoseTargets& g) {
    const Problem& problem = *g.problem;
    const PathRoles& roles = problem.mechanism->point->roles;
    if (is_linkage(problem)) return {0, false, -anywhere, anywhere, -anywhere, anywhere};
    const DimensionRange &x = problem.dimensions[roles.origin_x], &y = problem.dimensions[roles.origin_y];
    const double size = g.place.size;
    return {-g.place.origin / size, false, x.min / size, x.max / size, y.min / size, y.max / size};
}

}  // namespace mechwright
