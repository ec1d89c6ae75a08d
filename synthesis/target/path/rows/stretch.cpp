#include "synthesis/target/path/rows/stretch.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Of a margin's arguments, and of its components.
constexpr std::size_t most_reads = PointGuidance::most_reads + 1;
constexpr std::size_t most_pairs = most_reads * (most_reads + 1) / 2;
constexpr std::size_t most_components = InputRange::most_margins;

/// What a margin's argument follows from: a variable and a factor, or the difference of two variables; -1: none.
struct Argument {
    std::array<std::ptrdiff_t, 2> variable{-1, -1};
    std::array<double, 2> factor{0, 0};
};

/// How many arguments the margins have: dimensions, then start and range of the stretch.
std::size_t arguments_of_margin(const Program& program) { return program.problem->mechanism->input->reads.size() + 2; }

struct Arguments {
    std::array<double, most_reads> value{};
    std::array<Argument, most_reads> of{};
};

Arguments arguments_at(const Program& program, std::span<const double> dimensions, const VectorXd& x) {
    const Mechanism& mechanism = *program.problem->mechanism;
    const Reads& reads = mechanism.input->reads;
    Arguments all;
    const StretchEnds ends = stretch_ends(program, x);
    const PathAngle first = path_angle(program, dimensions, x, ends.first);
    const PathAngle last = path_angle(program, dimensions, x, ends.last);
    const double by_variable = program.untimed_path() ? 1 : program.times[mechanism.point->roles.start];
    const std::size_t start = reads.size(), range = start + 1;
    for (std::size_t i = 0; i < start; ++i) {
        all.value[i] = dimensions[reads[i]];
        all.of[i] = {{program.variable_of[reads[i]], -1}, {program.times[reads[i]], 0}};
    }
    all.value[start] = first.angle;
    all.of[start] = {{first.variable, -1}, {by_variable, 0}};
    all.value[range] = last.angle - first.angle;
    all.of[range] = {{last.variable, first.variable}, {by_variable, -by_variable}};
    return all;
}

/// Calls use(variable, factor) for every variable that an argument follows from.
template <class Use>
void for_each_variable(const Argument& argument, const Use& use) {
    for (std::size_t k = 0; k < 2; ++k)
        if (argument.variable[k] >= 0) use(argument.variable[k], argument.factor[k]);
}

}  // namespace

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
    std::array<double, most_components> value;
    Motion motion;
    motion.assembly = design.assembly;
    motion.model = problem.mechanism->model.data();
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

void evaluate_stretch(const Program& program, const VectorXd& x, bool derivatives, Outputs& out) {
    const QuantityBlock& block = *program.stretch;
    const std::size_t reads = arguments_of_margin(program);
    assert(block.count <= most_components);
    const Arguments arguments = arguments_at(program, out.dimensions, x);
    std::array<double, most_components> value;
    std::array<double, most_components * most_reads> gradient;
    Measurement measurement{value, {}, {}};
    if (derivatives) measurement.gradient = gradient;
    block.quantity->measure(block.motion, arguments.value, measurement);
    const auto first = static_cast<Index>(block.first);
    for (std::size_t k = 0; k < block.count; ++k)
        out.value[first + static_cast<Index>(k)] = value[k];
    for (std::size_t i = 0; derivatives && i < reads; ++i)
        for_each_variable(arguments.of[i], [&](std::ptrdiff_t variable, double factor) {
            for (std::size_t k = 0; k < block.count; ++k)
                out.jacobian(first + static_cast<Index>(k), variable) += factor * gradient[k * reads + i];
        });
}

void add_stretch_hessian(const Program& program, const VectorXd& x, LagrangianHessian& out) {
    const QuantityBlock& block = *program.stretch;
    const std::size_t reads = arguments_of_margin(program);
    const std::size_t pairs = reads * (reads + 1) / 2;
    const Arguments arguments = arguments_at(program, out.dimensions, x);
    std::array<double, most_components> value;
    std::array<double, most_components * most_reads> gradient;
    std::array<double, most_components * most_pairs> second;
    block.quantity->measure(block.motion, arguments.value, {value, gradient, second});
    for (std::size_t k = 0; k < block.count; ++k) {
        const double w = out.weights[static_cast<Index>(block.first + k)];
        if (w == 0) continue;
        for (std::size_t i = 0, at = k * pairs; i < reads; ++i)
            for (std::size_t j = 0; j <= i; ++j, ++at)
                for_each_variable(arguments.of[i], [&](std::ptrdiff_t a, double by_a) {
                    for_each_variable(arguments.of[j], [&](std::ptrdiff_t b, double by_b) {
                        const double part = w * by_a * by_b * second[at];
                        out.value(a, b) += part;
                        if (i != j) out.value(b, a) += part;
                    });
                });
    }
}

}  // namespace mechwright
