#include "synthesis/verify/motion_again.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <numbers>
#include <string_view>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/quick_return/again.h"

namespace mechwright {

namespace {

double plain(const Digits50& value) { return value.convert_to<double>(); }

/// The pin of the crank is between |ground - crank| and ground + crank away from the rocker's pivot, by the law of
/// cosines of its angle; the loop closes where that is between the difference and the sum of coupler and rocker.
Motion four_bar_motion(std::span<const Digits50> d) {
    constexpr std::size_t crank_rocker = 0, double_crank = 1, limited = 2;  // families
    const Digits50 ground = d[0], crank = d[1];
    const Digits50 difference = abs(d[2] - d[3]), sum = d[2] + d[3];
    const Digits50 nearest = abs(ground - crank), farthest = ground + crank;
    Motion motion;
    motion.full_turn = false;
    motion.family = limited;
    if (!(nearest <= sum) || !(farthest >= difference)) {
        motion.from = 1;
        return motion;
    }
    const bool near_is_out = nearest<difference, far_is_out = farthest> sum;
    if (!near_is_out && !far_is_out) {
        motion.full_turn = true;
        motion.family = crank <= ground ? crank_rocker : double_crank;
        motion.to = 2 * std::numbers::pi;
        return motion;
    }
    const auto angle_at = [&](const Digits50& distance) {
        const Digits50 cosine = (ground * ground + crank * crank - distance * distance) / (2 * ground * crank);
        return Digits50(acos(std::clamp<Digits50>(cosine, Digits50(-1), Digits50(1))));
    };
    const Digits50& turn = boost::math::constants::two_pi<Digits50>();
    const Digits50 first = near_is_out ? angle_at(difference) : Digits50(-angle_at(sum));
    const Digits50 last = far_is_out ? angle_at(sum) : Digits50(turn - first);
    motion.from = plain(first);
    motion.to = plain(last);
    return motion;
}

Motion whole_turn() {
    Motion motion;
    motion.to = 2 * std::numbers::pi;
    return motion;
}

Motion own_motion(std::string_view mechanism, std::size_t assembly, std::span<const Digits50> d) {
    using namespace quick_return;
    if (mechanism == "four-bar") return four_bar_motion(d);
    if (mechanism == "slider-crank") return SliderCrankAgain::motion(assembly, d);
    if (mechanism == "crank-shaper") return CrankShaperAgain::motion(assembly, d);
    if (mechanism == "whitworth") return WhitworthAgain::motion(assembly, d);
    if (mechanism == "drag-link") return DragLinkAgain::motion(assembly, d);
    return whole_turn();  // a cam
}

}  // namespace

Motion motion_again(const Mechanism& mechanism, std::size_t assembly, std::span<const Digits50> dimensions,
                    const std::optional<Vector<Digits50>>& range) {
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i)
        if (!is_cam(mechanism) && mechanism.dimensions[i].kind == DimensionKind::length && !(dimensions[i] > 0))
            return {.assembly = assembly, .full_turn = false, .from = 1, .to = 0};
    Motion motion = own_motion(mechanism.name, assembly, dimensions);
    motion.assembly = assembly;
    if (!range || is_cam(mechanism)) return motion;
    // A four-bar over a range still is a crank-rocker; a ram makes no strokes there.
    constexpr std::size_t limited_ram = 1;
    if (mechanism.name != "four-bar") motion.family = limited_ram;
    motion.full_turn = false;
    motion.from = plain(range->x);
    motion.to = plain(range->y);
    return motion;
}

}  // namespace mechwright
