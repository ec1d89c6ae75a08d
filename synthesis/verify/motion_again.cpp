#include "synthesis/verify/motion_again.h"

#include <algorithm>

namespace mechwright {

Motion motion_again(const Mechanism& mechanism, std::size_t assembly, std::span<const Digits50> dimensions,
                    const std::optional<Vector<Digits50>>& range) {
    const auto& all = mechanism.dimensions;
    const bool possible =
        std::equal(all.begin(), all.end(), dimensions.begin(),
                   [](const Dimension& d, const Digits50& x) { return d.kind != DimensionKind::length || x > 0; });
    Motion motion{.assembly = assembly, .full_turn = false, .from = 1, .to = 0};
    if (possible) motion = mechanism.motion_again(mechanism.form(assembly), dimensions, range);
    motion.model = mechanism.model.data();
    return motion;
}

}  // namespace mechwright
