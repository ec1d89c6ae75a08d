#include "synthesis/mechanism/four_bar/measure_again.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "synthesis/mechanism/four_bar/linkage_again.h"

namespace mechwright::four_bar {

namespace {

using namespace again;

const Digits50 nothing = std::numeric_limits<Digits50>::quiet_NaN();

const Digits50& full_turn() { return boost::math::constants::two_pi<Digits50>(); }

/// Measures along a motion, as Diagonal in linkage_again.h.
struct RockerAngle {
    template <class T>
    static T slope(const Linkage<T>&, const Pose<T>& p) {
        return cross(p.coupler, p.crank);
    }
};

struct VelocityRatio {
    /// The slope of r = crank n / s with n = cross(coupler, e) and s = cross(coupler, rocker), whose own slopes are
    /// (1 - k) dot(coupler, e) and (r - k) dot(coupler, rocker); multiplied by s^3 / crank.
    template <class T>
    static T slope(const Linkage<T>& m, const Pose<T>& p) {
        const T n = cross(p.coupler, p.crank);
        const T q = cross(p.rocker, p.crank);
        const T s = cross(p.coupler, p.rocker);
        return (s - m.crank * q) * dot(p.coupler, p.crank) * s - n * m.crank * (n - q) * dot(p.coupler, p.rocker);
    }
    static Digits50 value(const Linkage<Digits50>& m, const Pose<Digits50>& p) {
        return m.crank * cross(p.coupler, p.crank) / cross(p.coupler, p.rocker);
    }
};

struct Extremes {
    Digits50 least = nothing;
    Digits50 greatest = nothing;
};

/// Squares of lengths, relative to the links, that are nothing but the rounding of a crank angle.
const double toggle_within = 4e-15;

/// A value at an end of the motion. Where that is a toggle but for the rounding of its crank angle, the transmission
/// angle is that of the toggle, and the velocity ratio infinite.
Digits50 value_at_end(const TransmissionAngle&, const Linkage<Digits50>& m, const Pose<Digits50>& p) {
    if (abs(p.stretch) < toggle_within) return boost::math::constants::pi<Digits50>();
    if (abs(p.fold) < toggle_within) return 0;
    return TransmissionAngle::value(m, p);
}

Digits50 value_at_end(const VelocityRatio&, const Linkage<Digits50>& m, const Pose<Digits50>& p) {
    if (abs(p.stretch) >= toggle_within && abs(p.fold) >= toggle_within) return VelocityRatio::value(m, p);
    // cross(coupler, crank) by the triangle of crank pin and fixed pivots: next to a change point it is all rounding.
    const bool positive = m.side * p.crank.y * dot(p.coupler, p.diagonal) > 0;
    return positive ? std::numeric_limits<Digits50>::infinity() : -std::numeric_limits<Digits50>::infinity();
}

/// Crank angles on both sides of each change point of a sweep, in increasing order: the rocker turns a corner there
/// while one assembly is kept, so that a measure can be extreme without being stationary.
std::vector<Digits50> beside_change_points(const Linkage<Digits50>& m, const Sweep& sweep) {
    static const Digits50 beside("1e-24"), rounding("1e-45");
    const Digits50& half_turn = boost::math::constants::pi<Digits50>();
    std::vector<Digits50> angles;
    for (int k = int(std::ceil(sweep.from / std::numbers::pi)); k * std::numbers::pi <= sweep.to; ++k) {
        const Digits50 in_line = k * half_turn;
        const auto p = pose(m, in_line);
        if (abs(p.stretch) > rounding && abs(p.fold) > rounding) continue;
        for (const Digits50& x : {Digits50(in_line - beside), Digits50(in_line + beside)})
            if (x >= sweep.from && x <= sweep.to && pose(m, x).assembled()) angles.push_back(x);
    }
    return angles;
}

/// The crank angles of a sweep at which a measure can be extreme inside it.
template <class Measure>
std::vector<Digits50> candidates_of(const Linkage<Digits50>& m, const Sweep& sweep) {
    auto candidates = stationary_crank_angles<Measure>(m, sweep);
    const auto corners = beside_change_points(m, sweep);
    candidates.insert(candidates.end(), corners.begin(), corners.end());
    std::sort(candidates.begin(), candidates.end());
    return candidates;
}

/// The extremes of a measure over the motion: the values at its ends, at every stationary point, beside change points,
/// and at one place between for a measure that is constant.
template <class Measure>
Extremes extremes(const Motion& motion, std::span<const Digits50> dimensions) {
    if (!is_motion(motion)) return {};
    const auto m = linkage(motion.assembly, dimensions);
    const Sweep sweep = sweep_of(motion);
    auto candidates = candidates_of<Measure>(m, sweep);
    candidates.emplace_back(sweep.from + (sweep.to - sweep.from) / 2);
    Extremes e;
    const auto consider = [&e](const Digits50& value) {
        if (isnan(value)) return;
        if (!(value >= e.least)) e.least = value;
        if (!(value <= e.greatest)) e.greatest = value;
    };
    for (const Digits50& x : candidates)
        consider(Measure::value(m, pose(m, x)));
    for (const double end : {sweep.from, sweep.to})
        consider(value_at_end(Measure{}, m, pose(m, Digits50(end))));
    return e;
}

/// The two crank angles between which the rocker swings, with its angles there, continued from one to the other.
struct Strokes {
    Digits50 crank_at_least, crank_at_greatest;
    Digits50 least = nothing, greatest = nothing;
};

/// The stroke of a crank-rocker over a full turn. From sample to sample the rocker turns by less than half a turn,
/// which tells how often each of its angles has gone round.
Strokes strokes(const Motion& motion, std::span<const Digits50> dimensions) {
    constexpr std::size_t crank_rocker = 0;
    if (motion.family != crank_rocker) return {};
    const auto m = linkage(motion.assembly, dimensions);
    const auto plain = rounded<double>(m);
    const Sweep sweep = sweep_of(Motion{});
    const auto at = candidates_of<RockerAngle>(m, sweep);

    Strokes found;
    Vector<double> last = pose(plain, sweep.from).rocker;
    double continued = std::atan2(last.y, last.x);
    const auto follow = [&](double x) {
        const Vector<double> next = pose(plain, x).rocker;
        continued += std::atan2(cross(last, next), dot(last, next));
        last = next;
    };
    const auto samples = sample_angles(sweep);
    auto sample = samples.begin();
    for (const Digits50& x : at) {
        for (; sample != samples.end() && *sample < x; ++sample)
            follow(*sample);
        follow(x.convert_to<double>());
        const auto rocker = pose(m, x).rocker;
        Digits50 angle = atan2(rocker.y, rocker.x);
        angle += full_turn() * round((continued - angle) / full_turn());
        if (!(angle >= found.least)) {
            found.least = angle;
            found.crank_at_least = x;
        }
        if (!(angle <= found.greatest)) {
            found.greatest = angle;
            found.crank_at_greatest = x;
        }
    }
    return found;
}

}  // namespace

Digits50 time_ratio_again(const Motion& motion, std::span<const Digits50> dimensions) {
    // A coupler that lies on its crank for half a turn lets the rocker stand still: no stroke begins or ends there.
    if (dimensions[1] == dimensions[2] && dimensions[0] == dimensions[3]) return nothing;
    const Strokes s = strokes(motion, dimensions);
    if (isnan(s.least)) return nothing;
    Digits50 one = abs(s.crank_at_greatest - s.crank_at_least);
    if (one > full_turn()) one -= full_turn();
    const Digits50 other = full_turn() - one;
    return one > other ? one / other : other / one;
}

Digits50 swing_again(const Motion& motion, std::span<const Digits50> dimensions) {
    const Strokes s = strokes(motion, dimensions);
    return s.greatest - s.least;
}

Digits50 transmission_angle_min_again(const Motion& motion, std::span<const Digits50> dimensions) {
    return extremes<TransmissionAngle>(motion, dimensions).least;
}

Digits50 transmission_angle_max_again(const Motion& motion, std::span<const Digits50> dimensions) {
    return extremes<TransmissionAngle>(motion, dimensions).greatest;
}

Digits50 transmission_angle_worst_again(const Motion& motion, std::span<const Digits50> dimensions) {
    const Extremes e = extremes<TransmissionAngle>(motion, dimensions);
    const Digits50 supplement = boost::math::constants::pi<Digits50>() - e.greatest;
    return e.least < supplement ? e.least : supplement;
}

Digits50 velocity_ratio_min_again(const Motion& motion, std::span<const Digits50> dimensions) {
    return extremes<VelocityRatio>(motion, dimensions).least;
}

Digits50 velocity_ratio_max_again(const Motion& motion, std::span<const Digits50> dimensions) {
    return extremes<VelocityRatio>(motion, dimensions).greatest;
}

Digits50 link_ratio_again(const Motion&, std::span<const Digits50> dimensions) {
    return longest_link(dimensions) / *std::min_element(dimensions.begin(), dimensions.begin() + 4);
}

Digits50 total_length_again(const Motion&, std::span<const Digits50> dimensions) {
    return dimensions[0] + dimensions[1] + dimensions[2] + dimensions[3];
}

Digits50 grashof_margin_again(const Motion& motion, std::span<const Digits50> dimensions) {
    const Digits50 shortest = *std::min_element(dimensions.begin(), dimensions.begin() + 4);
    return total_length_again(motion, dimensions) - 2 * (shortest + longest_link(dimensions));
}

}  // namespace mechwright::four_bar

namespace mechwright {

Vector<Digits50> four_bar_path_point(Form form, std::span<const Digits50> dimensions, const Digits50& crank_angle) {
    const auto m = four_bar::again::linkage(form.assembly, dimensions);
    const auto p = four_bar::again::pose(m, crank_angle);
    if (!p.assembled()) return {four_bar::nothing, four_bar::nothing};
    const Digits50 unit = four_bar::again::length_unit(dimensions);
    const Vector<Digits50> along = (1 / m.coupler) * p.coupler;
    const Vector<Digits50> local = (m.crank * unit) * p.crank + dimensions[4] * along + dimensions[5] * left_of(along);
    const Vector<Digits50> tilt{cos(dimensions[8]), sin(dimensions[8])};
    return Vector<Digits50>{dimensions[6], dimensions[7]} + turned(local, tilt);
}

}  // namespace mechwright
