#include "synthesis/target/function/draw.h"

#include <array>
#include <limits>

#include "synthesis/target/function/function_target.h"

namespace mechwright {

double function_error(const FinishedDesign& design, double share) {
    const Mechanism& mechanism = *design.mechanism;
    FunctionTarget here;
    here.parts = {{share, part_at(*design.function, share)}};
    std::array<double, Reads::most> room;
    const auto errors =
        mechanism.function->extremes(here, mechanism.form(design.motion.assembly),
                                     deviation_from(mechanism, "function").reads.of(design.dimensions, room));
    return errors.empty() ? std::numeric_limits<double>::quiet_NaN() : errors.front().error;
}

}  // namespace mechwright
