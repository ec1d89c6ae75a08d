#include "synthesis/search/path/path_timing.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

#include "synthesis/mechanism/cycle.h"
#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

namespace {

constexpr double turn = 2 * std::numbers::pi;

using Points = std::span<const Vector<double>>;

/// The part of the whole way that lies before each point.
std::vector<double> parts_of_way(const Points& points) {
    std::vector<double> along(points.size(), 0.0);
    for (std::size_t i = 1; i < points.size(); ++i)
        along[i] = along[i - 1] + std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    const double whole = along.back();
    for (double& a : along)
        a = whole > 0 ? a / whole : 0;
    return along;
}

/// The turn of the crank from the first to the last point of a target.
double swept(const Points& points, bool closed, double span, double cycle) {
    const Vector<double>&first = points.front(), &last = points.back();
    if (points.size() > 2 && first.x == last.x && first.y == last.y) return cycle;
    if (!closed) return (0.1 + 0.85 * span) * cycle;
    double way = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        way += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    const double way_of_gap = std::hypot(last.x - first.x, last.y - first.y);
    const double n = static_cast<double>(points.size());
    const double by_way = way > 0 ? way / (way + way_of_gap) : 1;
    return 0.5 * (by_way + (n - 1) / n) * cycle;
}

/// Where the points of a target are met: the first, and how much further the last.
struct Way {
    double first, whole;
};

Way way_round(const Points& points, bool closed, double cycle, const PathTiming& timing) {
    return {(timing.start - 0.5) * cycle, swept(points, closed, timing.span, cycle)};
}

/// On the stroke of a slide, in and out.
Way way_along(const std::array<double, 2>& stroke, int direction, const PathTiming& timing) {
    const double width = stroke[1] - stroke[0], whole = (0.1 + 0.9 * timing.span) * width;
    const double before = timing.start * (width - whole);
    return {direction > 0 ? stroke[0] + before : stroke[1] - before, whole};
}

/// Those of one target.
void set_angles(const Points& points, int direction, const Way& way, const PathTiming& timing,
                std::span<double> angles) {
    const std::size_t n = points.size();
    std::vector<double> parts = parts_of_way(points);

    // A swell keeps the ends and the order: its slope is less than one.
    const double swell = 0.9 * timing.swell / turn;
    const double phase = timing.where * turn;
    for (std::size_t i = 0; i < n; ++i) {
        const double even = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0;
        const double part = timing.evenness * even + (1 - timing.evenness) * parts[i];
        const double swelled = part + swell * (std::sin(turn * part + phase) - std::sin(phase));
        angles[i] = way.first + direction * way.whole * swelled;
    }
}

/// A number in (0, 1) for a target after the first, drawn from the one that the first has.
double of_target(double number, std::size_t target) {
    if (target == 0) return number;
    const auto bits = mixed(static_cast<std::uint64_t>(std::ldexp(number, 53)) + target);
    return std::ldexp(static_cast<double>(bits >> 11) + 0.5, -53);
}

/// Of several targets each has a timing of its own.
PathTiming timing_of_target(const PathTiming& timing, std::size_t target) {
    return {of_target(timing.start, target), of_target(timing.span, target), of_target(timing.evenness, target),
            of_target(timing.swell, target), of_target(timing.where, target)};
}

}  // namespace

std::vector<double> path_angles(const Program& program, const PathTiming& timing) {
    const PathTarget& path = *program.problem->path;
    const double cycle = cycle_of(*program.problem->mechanism);
    const auto stroke = stroke_of(program);
    std::vector<double> angles(program.targets.size());
    for (std::size_t target = 0; target < path.targets(); ++target) {
        const PointRange points = path.points_of(target);
        const bool closed = path.parts.empty() ? path.closed : path.parts[target].closed;
        const Points own = Points(program.targets).subspan(points.first, points.count);
        const PathTiming drawn = timing_of_target(timing, target);
        const int direction = program.variant.direction;
        set_angles(own, direction, stroke ? way_along(*stroke, direction, drawn) : way_round(own, closed, cycle, drawn),
                   drawn, std::span(angles).subspan(points.first, points.count));
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
    std::vector<double> begins;
    for (std::size_t target = 0; target < path.targets(); ++target) {
        const std::size_t start = program.problem->mechanism->roles_of(target).start;
        const std::ptrdiff_t variable = program.variable_of[start];
        begins.push_back(program.dimensions[start]);
        if (variable < 0) continue;
        const Variable& v = program.variables[static_cast<std::size_t>(variable)];
        begins.back() = v.lower + of_target(sequence(k, 0), target) * (v.upper - v.lower);
        x[variable] = begins.back();
    }
    std::vector<double> angles;
    for (std::size_t i = 0; i < path.crank_angles.size(); ++i)
        angles.push_back(begins[path.target_of(i)] + path.crank_angles[i] / unit_of_input(program));
    return angles;
}

void meet_in_order(const Problem& problem, int direction, Design& design) {
    if (!comes_round(*problem.mechanism)) return;
    const double cycle = cycle_of(*problem.mechanism);
    for (std::size_t target = 0; target < problem.path->targets(); ++target) {
        const PointRange points = problem.path->points_of(target);
        for (std::size_t i = points.first + 1; i < points.end(); ++i) {
            double& angle = design.path_angles[i];
            const double before = design.path_angles[i - 1];
            angle -= direction * cycle * std::floor(direction * (angle - before) / cycle);
        }
    }
}

}  // namespace mechwright
