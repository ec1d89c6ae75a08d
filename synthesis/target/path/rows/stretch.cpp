#include "synthesis/target/path/rows/stretch.h"

#include <algorithm>
#include <array>

#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

using Eigen::VectorXd;

bool needs_stretch(const Problem& problem, const Family& family) {
    return problem.path && problem.path->points.size() > 1 && !problem.path->closed && !family.full_turn &&
           problem.mechanism->input.has_value();
}

CrankStretch stretch_of(const Problem& problem, std::span<const double> path_angles) {
    if (!problem.path->prescribed_timing && !problem.path->any_order) {
        const auto [low, high] = std::minmax(path_angles.front(), path_angles.back());
        return {low, high};
    }
    const auto [least, greatest] = std::minmax_element(path_angles.begin(), path_angles.end());
    return {*least, *greatest};
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

StretchEnds stretch_ends(const Program& program, const VectorXd& x) {
    const PathTarget& path = *program.problem->path;
    const std::size_t last = path.points.size() - 1;
    const auto index = [](const auto& at, const auto& begin) { return static_cast<std::size_t>(at - begin); };
    if (path.prescribed_timing) {
        const auto& angles = path.crank_angles;
        const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
        return {index(least, angles.begin()), index(greatest, angles.begin())};
    }
    if (!path.any_order) return {0, last};
    const double* begin = x.data() + program.first_path_angle;
    const auto [least, greatest] = std::minmax_element(begin, begin + path.points.size());
    return {index(least, begin), index(greatest, begin)};
}

const QuantityBlock* stretch_block(const Program& program) {
    const auto block = std::find_if(program.blocks.begin(), program.blocks.end(),
                                    [](const QuantityBlock& b) { return b.along_stretch; });
    return block == program.blocks.end() ? nullptr : &*block;
}

void set_stretch_arguments(const Program& program, std::span<const double> dimensions, const VectorXd& x,
                           BlockArguments& arguments) {
    const Mechanism& mechanism = *program.problem->mechanism;
    for (std::size_t i = 0; i < mechanism.input->reads.size(); ++i)
        add_dimension(program, dimensions, mechanism.input->reads[i], arguments);
    const StretchEnds ends = stretch_ends(program, x);
    const PathAngle first = path_angle(program, dimensions, x, ends.first);
    const PathAngle last = path_angle(program, dimensions, x, ends.last);
    const double by_variable = program.untimed_path() ? 1 : program.times[mechanism.point->roles.start];
    std::size_t& i = arguments.count;
    arguments.value[i] = first.angle;
    arguments.source[i++] = {{first.variable, -1}, {by_variable, 0}};
    arguments.value[i] = last.angle - first.angle;
    arguments.source[i++] = {{last.variable, first.variable}, {by_variable, -by_variable}};
}

}  // namespace mechwright
