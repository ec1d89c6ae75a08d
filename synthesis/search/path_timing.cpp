#include "synthesis/search/path_timing.h"

#include <cmath>
#include <numbers>

namespace mechwright {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// The part of the whole way that lies before each point.
std::vector<double> parts_of_way(const std::vector<Vector<double>>& points) {
    std::vector<double> along(points.size(), 0.0);
    for (std::size_t i = 1; i < points.size(); ++i)
        along[i] = along[i - 1] + std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    const double whole = along.back();
    for (double& a : along)
        a = whole > 0 ? a / whole : 0;
    return along;
}

/// The turn of the crank from the first to the last point.
double swept(const Program& program, double span) {
    const auto& points = program.targets;
    const Vector<double>&first = points.front(), &last = points.back();
    if (points.size() > 2 && first.x == last.x && first.y == last.y) return turn;
    if (!program.problem->path->closed) return (0.1 + 0.85 * span) * turn;
    double way = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        way += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    const double way_of_gap = std::hypot(last.x - first.x, last.y - first.y);
    const double n = static_cast<double>(points.size());
    const double by_way = way > 0 ? way / (way + way_of_gap) : 1;
    return 0.5 * (by_way + (n - 1) / n) * turn;
}

}  // namespace

std::vector<double> path_angles(const Program& program, const PathTiming& timing) {
    const std::size_t n = program.targets.size();
    std::vector<double> parts = parts_of_way(program.targets);

    const double whole = swept(program, timing.span);
    const double first = (timing.start - 0.5) * turn;
    // A swell keeps the ends and the order: its slope is less than one.
    const double swell = 0.9 * timing.swell / turn;
    const double phase = timing.where * turn;
    std::vector<double> angles(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double even = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0;
        const double part = timing.evenness * even + (1 - timing.evenness) * parts[i];
        const double swelled = part + swell * (std::sin(turn * part + phase) - std::sin(phase));
        angles[i] = first + program.variant.direction * whole * swelled;
    }
    return angles;
}

std::vector<double> random_path_angles(const Program& program, const LowDiscrepancy& sequence, std::uint64_t k,
                                       Eigen::VectorXd& x) {
    const PathTarget& path = *program.problem->path;
    if (program.untimed_path()) {
        const std::vector<double> angles =
            path_angles(program, {sequence(k, 0), sequence(k, 1), sequence(k, 2), sequence(k, 3), sequence(k, 4)});
        for (std::size_t i = 0; i < angles.size(); ++i)
            x[static_cast<Eigen::Index>(program.first_path_angle + i)] = angles[i];
        return angles;
    }
    const std::size_t start = program.problem->mechanism->point->roles.start;
    const std::ptrdiff_t variable = program.variable_of[start];
    double begin = program.dimensions[start];
    if (variable >= 0) {
        const Variable& v = program.variables[static_cast<std::size_t>(variable)];
        begin = v.lower + sequence(k, 0) * (v.upper - v.lower);
        x[variable] = begin;
    }
    std::vector<double> angles;
    for (const double angle : path.crank_angles)
        angles.push_back(begin + angle);
    return angles;
}

}  // namespace mechwright
