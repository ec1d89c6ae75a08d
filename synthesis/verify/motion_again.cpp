#include "synthesis/verify/motion_again.h"

namespace mechwright {

Motion motion_again(const Mechanism& mechanism, std::size_t assembly, std::span<const Digits50> dimensions,
                    const std::optional<Vector<Digits50>>& range) {
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i)
        if (mechanism.dimensions[i].kind == DimensionKind::length && !(dimensions[i] > 0))
            return {.assembly = assembly, .full_turn = false, .from = 1, .to = 0};
    Motion motion = mechanism.motion_again(mechanism.form(assembly), dimensions, range);
    motion.model = mechanism.model.data();
    return motion;
}

}  // namespace mechwright
