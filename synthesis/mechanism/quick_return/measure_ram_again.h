#pragma once
/// \file
/// The measures of again.h as templates on the geometry. Included by the files that make them for a kind of mechanism.

#include <algorithm>
#include <limits>

#include "synthesis/mechanism/four_bar/measure_again.h"
#include "synthesis/mechanism/quick_return/again.h"
#include "synthesis/mechanism/quick_return/ram_places.h"

namespace mechwright::quick_return::again {

inline const Digits50 nothing = std::numeric_limits<Digits50>::quiet_NaN();

inline const Digits50& full_turn_angle() { return boost::math::constants::two_pi<Digits50>(); }

/// A place where a measure of the ram can be extreme.
struct Candidate {
    Digits50 crank_angle;
    bool end;  ///< of a limited motion
};

/// Stationary crank angles, and the ends of a limited motion.
template <class Geometry>
std::vector<Candidate> candidates(const Rebuilt<Geometry>& m, const Motion& motion, Slope what) {
    const Sweep sweep = sweep_of(motion);
    std::vector<Candidate> all;
    for (const Digits50& x : stationary_crank_angles(m, sweep, what))
        all.push_back({x, false});
    if (motion.full_turn) return all;
    all.push_back({Digits50(sweep.from), true});
    all.push_back({Digits50(sweep.to), true});
    return all;
}

/// The crank angles with the least and the greatest ram position over a motion.
struct Limits {
    Digits50 inner_at, outer_at;
    Digits50 inner = nothing, outer = nothing;
};

template <class Geometry>
Limits limits(const Rebuilt<Geometry>& m, const Motion& motion) {
    Limits found;
    for (const auto& [x, end] : candidates(m, motion, Slope::position)) {
        const auto s = m.at(x);
        const Digits50 position = end && m.rod_is_square(s) ? s.pin.c[0] : s.position.c[0];
        if (isnan(position)) continue;
        if (!(position >= found.inner)) {
            found.inner = position;
            found.inner_at = x;
        }
        if (!(position <= found.outer)) {
            found.outer = position;
            found.outer_at = x;
        }
    }
    return found;
}

/// The angle from one crank angle on to another, in [0, 2 pi).
inline Digits50 ahead(const Digits50& from, const Digits50& to) {
    const Digits50 angle = to - from;
    return angle - full_turn_angle() * floor(angle / full_turn_angle());
}

/// The slow stroke: it begins at a limit of the ram and takes an angle.
struct SlowStroke {
    Digits50 begin, angle;
    Digits50 first, last;  ///< positions
};

inline SlowStroke slow_stroke(const Limits& l) {
    const Digits50 outward = ahead(l.inner_at, l.outer_at);
    const Digits50 inward = full_turn_angle() - outward;
    if (outward >= inward) return {l.inner_at, outward, l.inner, l.outer};
    return {l.outer_at, inward, l.outer, l.inner};
}

/// Greatest of a derivative's absolute value (order 1: speed, 2: acceleration) over the motion.
template <class Geometry>
Digits50 greatest(const Rebuilt<Geometry>& m, const Motion& motion, std::size_t order) {
    Digits50 most = nothing;
    for (const auto& [x, end] : candidates(m, motion, order == 1 ? Slope::velocity : Slope::acceleration)) {
        const auto s = m.at(x);
        if (end && m.is_dead_position(s, x)) return std::numeric_limits<Digits50>::infinity();
        const Digits50 value = abs(s.position.c[order]) * (order == 1 ? 1 : 2);
        if (!isnan(value) && !(value <= most)) most = value;
    }
    return m.unit * most;
}

/// Speeds on the working part of the slow stroke, lengths over the unit.
struct Working {
    Digits50 least = nothing, greatest = nothing;
    Digits50 mean;
};

template <class Geometry>
Working working(const Rebuilt<Geometry>& m, const Motion& motion) {
    Working w;
    const Limits l = limits(m, motion);
    if (isnan(l.inner) || !(l.outer > l.inner)) return w;
    const SlowStroke slow = slow_stroke(l);
    const double share = motion.settings[0];
    const auto reached = [&](const Digits50& part) {
        const Digits50 target = slow.first + part * (slow.last - slow.first);
        const auto off = [&](const Digits50& x) { return (m.at(x).position.c[0] - target) / (slow.last - slow.first); };
        const Digits50 end = slow.begin + slow.angle;
        return mechwright::detail::zero_between_signs(off, slow.begin, end, Digits50(-part), Digits50(1 - part), 1e-44);
    };
    const Digits50 margin = (1 - Digits50(share)) / 2;
    const Digits50 from = reached(margin), to = reached(1 - margin);
    auto places =
        stationary_crank_angles(m, Sweep{from.convert_to<double>(), to.convert_to<double>()}, Slope::velocity);
    std::erase_if(places, [&](const Digits50& x) { return x < from || x > to; });
    places.push_back(from);
    places.push_back(to);
    for (const Digits50& x : places) {
        const Digits50 speed = abs(m.at(x).position.c[1]);
        if (!(speed >= w.least)) w.least = speed;
        if (!(speed <= w.greatest)) w.greatest = speed;
    }
    w.mean = share * (l.outer - l.inner) / (to - from);
    return w;
}

/// The least and the greatest angle at the ram, a right angle less the slope of the rod.
struct AtRam {
    Digits50 least = nothing, greatest = nothing;
};

template <class Geometry>
AtRam at_ram(const Rebuilt<Geometry>& m, const Motion& motion) {
    AtRam found;
    bool rising = false, falling = false;  // the rod
    for (const auto& [x, end] : candidates(m, motion, Slope::rod_height)) {
        const auto s = m.at(x);
        const Digits50 angle =
            end && m.rod_is_square(s) ? Digits50(0) : Digits50(atan2(s.run.c[0], abs(s.height.c[0])));
        if (isnan(angle)) continue;
        if (!(angle >= found.least)) found.least = angle;
        if (!(angle <= found.greatest)) found.greatest = angle;
        (s.height.c[0] >= 0 ? rising : falling) = true;
    }
    if (rising && falling) found.greatest = boost::math::constants::half_pi<Digits50>();
    return found;
}

template <class Geometry>
Digits50 RamAgain<Geometry>::stroke(const Motion& motion, Dimensions dimensions) {
    if (!is_motion(motion)) return nothing;
    const Rebuilt<Geometry> m(motion.assembly, dimensions);
    const Limits l = limits(m, motion);
    return m.unit * (l.outer - l.inner);
}

template <class Geometry>
Digits50 RamAgain<Geometry>::time_ratio(const Motion& motion, Dimensions dimensions) {
    if (motion.family != two_strokes) return nothing;
    const Limits l = limits(Rebuilt<Geometry>(motion.assembly, dimensions), motion);
    if (isnan(l.inner)) return nothing;
    const Digits50 slow = slow_stroke(l).angle;
    return slow / (full_turn_angle() - slow);
}

template <class Geometry>
Digits50 RamAgain<Geometry>::transmission_angle_min(const Motion& motion, Dimensions dimensions) {
    if (!is_motion(motion)) return nothing;
    const Digits50 least = at_ram(Rebuilt<Geometry>(motion.assembly, dimensions), motion).least;
    if constexpr (Geometry::has_four_bar)
        return std::min<Digits50>(least, four_bar::transmission_angle_min_again(motion, dimensions));
    return least;
}

template <class Geometry>
Digits50 RamAgain<Geometry>::transmission_angle_max(const Motion& motion, Dimensions dimensions) {
    if (!is_motion(motion)) return nothing;
    const Digits50 most = at_ram(Rebuilt<Geometry>(motion.assembly, dimensions), motion).greatest;
    if constexpr (Geometry::has_four_bar)
        return std::max<Digits50>(most, four_bar::transmission_angle_max_again(motion, dimensions));
    return most;
}

template <class Geometry>
Digits50 RamAgain<Geometry>::transmission_angle_worst(const Motion& motion, Dimensions dimensions) {
    if (!is_motion(motion)) return nothing;
    const Digits50 least = at_ram(Rebuilt<Geometry>(motion.assembly, dimensions), motion).least;
    if constexpr (Geometry::has_four_bar)
        return std::min<Digits50>(least, four_bar::transmission_angle_worst_again(motion, dimensions));
    return least;
}

template <class Geometry>
Digits50 RamAgain<Geometry>::ram_speed_max(const Motion& motion, Dimensions dimensions) {
    return is_motion(motion) ? greatest(Rebuilt<Geometry>(motion.assembly, dimensions), motion, 1) : nothing;
}

template <class Geometry>
Digits50 RamAgain<Geometry>::ram_acceleration_max(const Motion& motion, Dimensions dimensions) {
    return is_motion(motion) ? greatest(Rebuilt<Geometry>(motion.assembly, dimensions), motion, 2) : nothing;
}

template <class Geometry>
Digits50 RamAgain<Geometry>::ram_speed_min_working(const Motion& motion, Dimensions dimensions) {
    if (motion.family != two_strokes) return nothing;
    const Rebuilt<Geometry> m(motion.assembly, dimensions);
    return m.unit * working(m, motion).least;
}

template <class Geometry>
Digits50 RamAgain<Geometry>::speed_variation(const Motion& motion, Dimensions dimensions) {
    if (motion.family != two_strokes) return nothing;
    const Working w = working(Rebuilt<Geometry>(motion.assembly, dimensions), motion);
    return (w.greatest - w.least) / w.mean;
}

template <class Geometry>
Digits50 RamAgain<Geometry>::link_ratio(const Motion&, Dimensions dimensions) {
    Digits50 shortest = dimensions[Geometry::links[0]], longest = shortest;
    for (const std::size_t i : Geometry::links) {
        shortest = std::min(shortest, dimensions[i]);
        longest = std::max(longest, dimensions[i]);
    }
    return longest / shortest;
}

template <class Geometry>
Digits50 RamAgain<Geometry>::total_length(const Motion&, Dimensions dimensions) {
    Digits50 sum = 0;
    for (const std::size_t i : Geometry::links)
        sum += dimensions[i];
    return sum;
}

}  // namespace mechwright::quick_return::again
