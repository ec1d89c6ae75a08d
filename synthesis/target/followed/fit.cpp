#include "synthesis/target/followed/fit.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

void fit_followed(const Program& program, const InputTask& task, Eigen::VectorXd& x) {
    const FollowedShape& shape = *task.shape;
    std::vector<double> dimensions = dimensions_at(program, x);
    std::array<bool, 3> free{};
    const std::size_t numbers = shape.numbers.size();
    for (std::size_t k = 0; k < numbers; ++k)
        free[k] = program.variable_of[shape.place + k] >= 0;
    std::array<double, Reads::most> room;
    Form form = task.form(*program.problem->mechanism, program.variant.assembly);
    form.model = program.model.data();
    shape.fit(form, task.deviation->reads.of(dimensions, room), std::span(dimensions).subspan(shape.place, numbers),
              free);
    for (std::size_t k = 0; k < numbers; ++k) {
        if (!free[k]) continue;
        const std::ptrdiff_t v = program.variable_of[shape.place + k];
        const Variable& variable = program.variables[static_cast<std::size_t>(v)];
        x[v] = std::clamp(dimensions[shape.place + k], variable.lower, variable.upper);
    }
}

}  // namespace mechwright
