#include "synthesis/target/function/draw.h"

#include <array>
#include <limits>

#include "synthesis/target/function/function_target.h"

namespace mechwright {

double function_error(const FinishedDesign& design, const InputTask& task, double share) {
    const Mechanism& mechanism = *design.mechanism;
    FunctionTarget here;
    here.parts = {{share, part_at(*task.asked.function, share)}};
    std::array<double, Reads::most> room;
    const auto errors = task.generation->extremes(here, task.form(mechanism, design.motion.assembly),
                                                  task.deviation->reads.of(design.dimensions, room));
    return errors.empty() ? std::numeric_limits<double>::quiet_NaN() : errors.front().error;
}

}  // namespace mechwright
