#include "synthesis/target/path/rows/stretch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "synthesis/mechanism/cycle.h"
#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

using Eigen::VectorXd;

bool needs_stretch(const Problem& problem, const Family& family) {
    return problem.path && (problem.path->points.size() > 1 || problem.use) && !problem.path->closed &&
           !family.full_turn && problem.mechanism->input.has_value();
}

namespace {

/// The points of a target between whose crank angles it is met: of an ordered path the first and the last.
struct EndPoints {
    std::size_t least;
    std::size_t greatest;
};

template <class AngleAt>
EndPoints end_points(const PathTarget& path, std::size_t target, const AngleAt& angle_at) {
    const PointRange points = path.points_of(target);
    const bool ordered = !path.prescribed_timing && !path.any_order;
    EndPoints ends{points.first, points.first};
    for (std::size_t i = points.first; i < points.end(); ++i) {
        if (ordered && i > points.first && i + 1 < points.end()) continue;
        if (angle_at(i) < angle_at(ends.least)) ends.least = i;
        if (angle_at(i) > angle_at(ends.greatest)) ends.greatest = i;
    }
    return ends;
}

/// The shortest stretch that holds the crank angles of every target, each turned on by whole cycles: it begins where
/// one of them does. Points that count by the nearest of the curve lie in one motion, and are not turned.
template <class AngleAt>
StretchEnds shortest_stretch(const PathTarget& path, double cycle, const AngleAt& angle_at) {
    const std::size_t targets = path.targets();
    StretchEnds best;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t from = 0; from < targets; ++from) {
        const double begin = angle_at(end_points(path, from, angle_at).least);
        StretchEnds ends;
        ends.first = ends.last = end_points(path, from, angle_at).least;
        double least = begin, greatest = begin;
        for (std::size_t k = 0; k < targets; ++k) {
            const EndPoints of = end_points(path, k, angle_at);
            const double turns =
                k == from || path.any_order ? 0 : cycle * std::ceil((begin - angle_at(of.least)) / cycle);
            if (angle_at(of.least) + turns < least) {
                least = angle_at(of.least) + turns;
                ends.first = of.least;
            }
            if (angle_at(of.greatest) + turns > greatest) {
                greatest = angle_at(of.greatest) + turns;
                ends.last = of.greatest;
                ends.turns = turns;
            }
        }
        if (!(greatest - least < shortest)) continue;
        shortest = greatest - least;
        best = ends;
    }
    return best;
}

/// Whether the crank turns clockwise from the first target to the last: they are met in order as `angle_at` falls.
template <class AngleAt>
bool turns_clockwise(const PathTarget& path, const AngleAt& angle_at) {
    for (std::size_t target = 0; target < path.targets() && !path.any_order; ++target)
        if (const PointRange points = path.points_of(target); points.count > 1)
            return angle_at(points.end() - 1) < angle_at(points.first);
    return false;
}

/// By how much the range of use goes beyond the ends of a stretch: beyond the end at the lesser crank angle, then
/// beyond the other.
template <class AngleAt>
std::array<double, 2> beyond_ends(const Problem& problem, const AngleAt& angle_at) {
    if (!problem.use) return {0, 0};
    const auto [before, after] = *problem.use;
    return turns_clockwise(*problem.path, angle_at) ? std::array{after, before} : std::array{before, after};
}

}  // namespace

CrankStretch stretch_of(const Problem& problem, std::span<const double> path_angles) {
    const auto angle_at = [&](std::size_t i) { return path_angles[i]; };
    const StretchEnds ends = shortest_stretch(*problem.path, cycle_of(*problem.mechanism), angle_at);
    const auto [less, more] = beyond_ends(problem, angle_at);
    return {path_angles[ends.first] - less, path_angles[ends.last] + ends.turns + more};
}

double least_margin_along(const Problem& problem, const Design& design) {
    const InputRange& input = *problem.mechanism->input;
    const CrankStretch stretch = stretch_of(problem, design.path_angles);
    std::vector<double> arguments;
    for (const std::size_t i : input.reads)
        arguments.push_back(design.dimensions[i]);
    arguments.push_back(stretch.first);
    arguments.push_back(stretch.last - stretch.first);
    std::array<double, InputRange::most_margins> value;
    Motion motion;
    motion.assembly = design.assembly;
    motion.model = problem.mechanism->model.data();
    motion.of = input.margin.of.data();
    input.margin.measure(motion, arguments, {value, {}, {}});
    return *std::min_element(value.begin(),
                             value.begin() + static_cast<std::ptrdiff_t>(input.margin.components(motion)));
}

namespace {

/// The crank angle of a point, as a path has it.
double angle_at_point(const Program& program, const VectorXd& x, std::size_t i) {
    const PathTarget& path = *program.problem->path;
    if (program.untimed_path()) return x[static_cast<Eigen::Index>(program.first_path_angle + i)];
    const std::size_t start = program.problem->mechanism->roles_of(path.target_of(i)).start;
    const std::ptrdiff_t variable = program.variable_of[start];
    return path.crank_angles[i] + (variable < 0 ? program.dimensions[start] : x[variable]);
}

}  // namespace

StretchEnds stretch_ends(const Program& program, const VectorXd& x) {
    const PathTarget& path = *program.problem->path;
    // The crank may turn either way along an ordered path.
    if (path.parts.empty() && !path.prescribed_timing && !path.any_order) return {0, path.points.size() - 1, 0};
    return shortest_stretch(path, cycle_of(*program.problem->mechanism),
                            [&](std::size_t i) { return angle_at_point(program, x, i); });
}

const QuantityBlock* stretch_block(const Program& program) {
    const auto block = std::find_if(program.blocks.begin(), program.blocks.end(), [&](const QuantityBlock& b) {
        return b.along_stretch && b.quantity == &program.problem->mechanism->input->margin;
    });
    return block == program.blocks.end() ? nullptr : &*block;
}

bool depends_on_stretch(const Program& program) {
    return std::any_of(program.blocks.begin(), program.blocks.end(),
                       [](const QuantityBlock& b) { return b.along_stretch; });
}

void add_stretch(const Program& program, std::span<const double> dimensions, const VectorXd& x,
                 BlockArguments& arguments) {
    const Problem& problem = *program.problem;
    const StretchEnds ends = stretch_ends(program, x);
    const PathAngle first = path_angle(program, dimensions, x, ends.first);
    const PathAngle last = path_angle(program, dimensions, x, ends.last);
    const auto by = [](const PathAngle& angle, double factor) {
        return LinearTerm{static_cast<std::size_t>(angle.variable), factor};
    };
    arguments.ends = {by(first, 1), by(last, 1), by(first, -1)};
    const std::span<const LinearTerm> ends_by(arguments.ends);
    const std::size_t of_first = first.variable >= 0 ? 1 : 0, of_last = last.variable >= 0 ? 1 : 0;
    double start = first.angle, range = last.angle + ends.turns - first.angle;
    if (problem.use) {
        const auto [less, more] = beyond_ends(problem, [&](std::size_t i) { return angle_at_point(program, x, i); });
        // The first of an ordered path is at the greater crank angle where the crank turns clockwise.
        start += range < 0 ? more : -less;
        range += range < 0 ? -(less + more) : less + more;
    }
    std::size_t& i = arguments.count;
    arguments.value[i] = start;
    arguments.source[i++] = ends_by.first(of_first);
    arguments.value[i] = range;
    arguments.source[i++] = ends_by.subspan(2 - of_last, of_last + of_first);
}

}  // namespace mechwright
