#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <numbers>

#include "synthesis/mechanism/four_bar/measure_again.h"
#include "synthesis/mechanism/four_link_ways.h"
#include "synthesis/mechanism/over_range.h"

namespace mechwright {

namespace {

double plain(const Digits50& value) { return value.convert_to<double>(); }

/// The pin of the crank is between |ground - crank| and ground + crank away from the rocker's pivot, by the law of
/// cosines of its angle; the loop closes where that is between the difference and the sum of coupler and rocker.
Motion own_motion(std::span<const Digits50> d) {
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

}  // namespace

std::vector<Way> four_bar_ways_again(bool full_turn) {
    if (!full_turn) return {four_links_close("rocker")};
    return {crank_turns("ground", "crank", "rocker"), crank_turns("crank", "ground", "rocker")};
}

Motion four_bar_motion_again(Form form, std::span<const Digits50> dimensions,
                             const std::optional<Vector<Digits50>>& crank_range) {
    Motion motion = own_motion(dimensions);
    motion.assembly = form.assembly;
    // Over a range it still is a crank-rocker, if it is one.
    return crank_range ? over_range(motion, *crank_range) : motion;
}

}  // namespace mechwright
