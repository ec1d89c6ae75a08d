#include "synthesis/target/function/verify.h"

#include <fmt/format.h>

#include "synthesis/target/function/function_target.h"

namespace mechwright {

Check check_accuracy_points(const Rebuilt& design) {
    constexpr double met_within = 1e-9;  // radians, or a length
    const Claim& claim = *design.claim;
    const FunctionTarget points = at_accuracy_points(*claim.function);
    Motion motion = design.motion;
    motion.function = &points;
    const Digits50 error = measure_again(deviation_from(*claim.mechanism, "function"), motion, design.dimensions);
    const bool angle = claim.mechanism->function->output.kind == DimensionKind::angle;
    return {"meets the function at the accuracy points", error <= met_within,
            isfinite(error) ? fmt::format("the greatest error is {}{}, allowed is {}", size_text(error),
                                          angle ? " rad" : "", size_text(met_within))
                            : std::string("the mechanism does not assemble at one of them")};
}

}  // namespace mechwright
