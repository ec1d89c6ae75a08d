#include "synthesis/target/function/fit.h"

#include <algorithm>
#include <span>
#include <vector>

#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

void fit_function(const Program& program, const InputTask& task, Eigen::VectorXd& x) {
    std::vector<double> dimensions = dimensions_at(program, x);
    const std::size_t start = task.start;
    const auto scale_ranges = std::span(program.problem->dimensions).subspan(start, 4);
    if (std::any_of(scale_ranges.begin(), scale_ranges.end(), [](const DimensionRange& range) { return range.tied(); }))
        return;
    const auto turns = [&](std::size_t dimension) { return program.variable_of[dimension] >= 0; };
    const std::span<double, 4> scales(dimensions.data() + start, 4);
    if (!task.generation->fit(*task.asked.function, dimensions, scales, turns(start), turns(start + 2))) return;
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
        const std::ptrdiff_t v = program.variable_of[i];
        if (v < 0) continue;
        const Variable& variable = program.variables[static_cast<std::size_t>(v)];
        x[v] = std::clamp(dimensions[i], variable.lower, variable.upper);
    }
}

}  // namespace mechwright
