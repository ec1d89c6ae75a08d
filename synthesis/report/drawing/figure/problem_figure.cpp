#include "synthesis/report/drawing/figure/problem_figure.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "synthesis/mechanism/linkage/drawing/figure.h"
#include "synthesis/mechanism/linkage/model.h"

namespace mechwright {

namespace {

std::vector<double> usual_numbers(const Problem& problem) {
    std::vector<double> numbers;
    for (const DimensionRange& range : problem.dimensions)
        numbers.push_back(range.start.value_or(0.5 * (range.min + range.max)));
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (problem.dimensions[i].tied()) numbers[i] = problem.dimensions[i].tie.at(std::span<const double>(numbers));
    return numbers;
}

/// In the first assembly in which it assembles.
std::optional<MovingDesign> usual_design(const Problem& problem) {
    const Mechanism& m = *problem.mechanism;
    MovingDesign design{problem.mechanism, {}, usual_numbers(problem), false, false};
    std::array<double, 2> range{};
    if (problem.crank_range) range = {problem.crank_range->x, problem.crank_range->y};
    for (std::size_t assembly = 0; assembly < std::max<std::size_t>(1, m.assemblies.size()); ++assembly) {
        design.motion = motion_of(m, design.dimensions, assembly, problem.crank_range ? range.data() : nullptr);
        if (design.assembles()) return design;
    }
    return std::nullopt;
}

}  // namespace

std::vector<FigurePanel> figure_of(const Problem& problem) {
    if (problem.mechanism->model.as<LinkageModel>() == nullptr) return figure_of(*problem.mechanism);
    const std::optional<MovingDesign> design = usual_design(problem);
    return design ? std::vector{linkage_panel(*design)} : std::vector<FigurePanel>{};
}

}  // namespace mechwright
