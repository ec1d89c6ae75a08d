#include "synthesis/target/path/rows/path_rows.h"

#include <algorithm>
#include <array>
#include <string>

#include "synthesis/mechanism/cycle.h"
#include "synthesis/target/path/read_parts.h"
#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

namespace {

/// The least crank angle between neighbouring points of an untimed path.
constexpr double least_between = 1e-6;

/// The displacements at the points of a target.
void add_displacements(Program& program, const PathTarget& path, const PointRange& points,
                       const std::array<double, 2>& stroke) {
    for (std::size_t i = points.first; i < points.end(); ++i)
        program.variables.push_back({"displacement at " + point_name(path, i), stroke[0], stroke[1]});
}

/// The crank angles at the points of a target; the first of ordered ones is in the first cycle.
void add_angles(Program& program, const PathTarget& path, const PointRange& points) {
    if (const auto stroke = stroke_of(program)) return add_displacements(program, path, points, *stroke);
    const double half = cycle_of(*program.problem->mechanism) / 2;
    const int direction = program.variant.direction;
    for (std::size_t i = points.first; i < points.end(); ++i) {
        const bool first = i == points.first;
        program.variables.push_back({"crank angle at " + point_name(path, i),
                                     path.any_order           ? -3 * half
                                     : first || direction > 0 ? -half
                                                              : -3 * half,
                                     path.any_order           ? 3 * half
                                     : first || direction < 0 ? half
                                                              : 3 * half});
    }
}

/// The points of each target by itself are met in order within a turn or a longer cycle, those of several in one
/// direction.
void add_order(Program& program, const PathTarget& path, const PointRange& points) {
    const double sign = program.variant.direction;
    const std::string of = path.parts.empty() ? "" : " of '" + path.parts[path.part_of[points.first]].name + "'";
    const auto angle = [&](std::size_t number) { return program.first_path_angle + points.first + number; };
    const auto add_row = [&](const std::string& name, std::size_t from, std::size_t to, double lower, double upper) {
        program.rows.push_back({name + of, {{}, {{angle(to), sign}, {angle(from), -sign}}}, lower, upper});
    };
    for (std::size_t i = 0; i + 1 < points.count; ++i)
        add_row("order of points " + std::to_string(i + 1) + " and " + std::to_string(i + 2), i, i + 1, least_between,
                unlimited);
    if (points.count < 3 || stroke_of(program)) return;
    const Vector<double>&first = path.points[points.first], &last = path.points[points.end() - 1];
    const bool meets = first.x == last.x && first.y == last.y;
    add_row("points within one turn", 0, points.count - 1, -unlimited,
            cycle_of(*program.problem->mechanism) - (meets ? 0 : least_between));
}

/// Keeps prescribed displacements, which are counted from a dimension, on the stroke.
void keep_on_stroke(Program& program, const PathTarget& path, std::size_t target, const std::array<double, 2>& stroke) {
    const std::size_t start = program.problem->mechanism->roles_of(target).start;
    if (program.follows[start].empty()) return;
    const PointRange points = path.points_of(target);
    const auto first = path.crank_angles.begin() + static_cast<std::ptrdiff_t>(points.first);
    const auto [least, greatest] = std::minmax_element(first, first + static_cast<std::ptrdiff_t>(points.count));
    const double unit = unit_of_input(program);
    program.rows.push_back({"displacements on the stroke",
                            {{}, program.follows[start], program.dimensions[start]},
                            stroke[0] - *least / unit,
                            stroke[1] - *greatest / unit});
}

}  // namespace

void add_path_rows(Program& program) {
    const PathTarget& path = *program.problem->path;
    program.path.emplace();
    for (const Vector<double>& point : path.points)
        program.targets.push_back({point.x / program.length, point.y / program.length});
    const auto stroke = stroke_of(program);
    for (std::size_t target = 0; path.prescribed_timing && stroke && target < path.targets(); ++target)
        keep_on_stroke(program, path, target, *stroke);
    if (path.prescribed_timing) return;
    program.first_path_angle = program.variables.size();
    for (std::size_t target = 0; target < path.targets(); ++target)
        add_angles(program, path, path.points_of(target));
    for (std::size_t target = 0; target < path.targets() && !path.any_order; ++target)
        add_order(program, path, path.points_of(target));
}

}  // namespace mechwright
