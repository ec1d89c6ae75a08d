#pragma once
/// \file
/// The quantities of ram-driving mechanisms as smooth components (measured.h), each from the analysis of the mechanism.
/// Those of the rod's transmission angle stand in transmission.h.

#include <array>
#include <cstddef>
#include <limits>

#include "synthesis/mechanism/quick_return/ram_extreme_places.h"

namespace mechwright::quick_return {

/// The two ways round: a ratio and its reciprocal. Of a crank shaper the outward stroke always is the slow one.
template <template <class> class Drive>
struct TimeRatio {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t most = Layout<Drive>::outward_is_slow ? 1 : 2;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        const Strokes<T> s = strokes(Layout<Drive>::make(x, motion.assembly));
        out[0] = s.outward / s.inward;
        if constexpr (most > 1) out[1] = s.inward / s.outward;
        return most;
    }
};

/// In closed form where the ram makes two strokes in each turn; else the greatest difference of two positions.
template <template <class> class Drive>
struct Stroke {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t turning_points = 4;
    static constexpr std::size_t most = (turning_points + 2) * (turning_points + 1);
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        return components(motion, x, out, fixed_ends<T>(motion));
    }

    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out,
                                  const Ends<T>& ends) {
        if (motion.family == full_turn) {
            out[0] = stroke(Layout<Drive>::make(x, motion.assembly));
            return 1;
        }
        const auto position = [&]<class U>(const std::array<U, reads>& dimensions, const U& angle) {
            return ram_position(Layout<Drive>::make(dimensions, motion.assembly), angle);
        };
        const Drive<double> plain = converted<double>(Layout<Drive>::make(x, motion.assembly));
        const auto inside =
            stationary_places<turning_points>(ram_position_extremes(plain, range_of(motion)), motion.from,
                                              [&](double angle) { return ram_position(plain, angle); });
        const auto at_end = [&](const T& angle) {
            return rod_is_square(plain, value_of(angle))
                       ? square_position(Layout<Drive>::make(x, motion.assembly), angle)
                       : position(x, angle);
        };
        std::array<T, turning_points + 2> at;
        at[0] = at_end(ends.from);
        at[1] = at_end(ends.to);
        for (std::size_t k = 0; k < turning_points; ++k)
            at[k + 2] = value_at(x, inside[k], position, ends);
        return differences(at, out);
    }
};

namespace detail {

/// Absolute values of a measure of the ram at its stationary points, and at the ends of a limited motion: infinite
/// where those are dead positions of `drive`.
template <std::size_t stationary_points, class Drive, class T, std::size_t reads, class Measure>
std::size_t absolute_values(const Motion& motion, const Drive& drive, const std::array<T, reads>& x,
                            const RamExtremes& extremes, const std::array<double, reads>& plain, const Measure& measure,
                            Components<T> out, const Ends<T>& ends) {
    using std::abs;
    const auto places = stationary_places<stationary_points>(
        extremes, motion.from, [&](double angle) { return std::abs(measure(plain, angle)); });
    std::size_t count = 0;
    for (const RamPlace& place : places)
        out[count++] = abs(value_at(x, place, measure, ends));
    if (motion.full_turn) return count;
    for (const T& end : {ends.from, ends.to})
        out[count++] = is_dead_position(drive, value_of(end)) ? T(std::numeric_limits<double>::infinity())
                                                              : T(abs(measure(x, end)));
    return count;
}

template <class T, std::size_t N>
std::array<double, N> plain_of(const std::array<T, N>& x) {
    std::array<double, N> plain;
    for (std::size_t i = 0; i < N; ++i)
        plain[i] = value_of(x[i]);
    return plain;
}

}  // namespace detail

/// The greatest absolute value of `Measure` of the ram, for unit crank speed.
template <template <class> class Drive, class Measure>
struct GreatestOfRam {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t stationary_points = Measure::stationary_points;
    static constexpr std::size_t most = stationary_points + 2;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        return components(motion, x, out, fixed_ends<T>(motion));
    }

    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out,
                                  const Ends<T>& ends) {
        const auto measure = [&]<class U>(const std::array<U, reads>& dimensions, const U& angle) {
            return Measure::value(Layout<Drive>::make(dimensions, motion.assembly), angle);
        };
        const auto plain = detail::plain_of(x);
        const auto drive = Layout<Drive>::make(plain, motion.assembly);
        const auto extremes = Measure::extremes(drive, range_of(motion));
        return detail::absolute_values<stationary_points>(motion, drive, x, extremes, plain, measure, out, ends);
    }
};

/// What GreatestOfRam measures: at a crank angle, and where it is stationary.
struct RamVelocity {
    static constexpr std::size_t stationary_points = 6;
    template <class Drive, class T>
    static T value(const Drive& m, const T& angle) {
        return ram_velocity(m, angle);
    }
    template <class Drive>
    static RamExtremes extremes(const Drive& m, const CrankRange<double>& range) {
        return ram_velocity_extremes(m, range);
    }
};

struct RamAcceleration {
    static constexpr std::size_t stationary_points = 8;
    template <class Drive, class T>
    static T value(const Drive& m, const T& angle) {
        return ram_acceleration(m, angle);
    }
    template <class Drive>
    static RamExtremes extremes(const Drive& m, const CrankRange<double>& range) {
        return ram_acceleration_extremes(m, range);
    }
};

template <template <class> class Drive>
using RamSpeedMax = GreatestOfRam<Drive, RamVelocity>;

template <template <class> class Drive>
using RamAccelerationMax = GreatestOfRam<Drive, RamAcceleration>;

/// Speeds of the ram on the working part: at its two ends, then where they are stationary between.
template <template <class> class Drive, class T>
struct WorkingSpeeds {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t stationary_points = 4;
    std::array<T, stationary_points + 2> speed;
    T duration;  ///< crank angle that the working part takes

    WorkingSpeeds(const Motion& motion, const std::array<T, reads>& x) {
        const auto m = Layout<Drive>::make(x, motion.assembly);
        const auto part = working_part(m, motion.settings[working_share]);
        const double sign = part.outward ? 1 : -1;
        const auto forward = [&]<class U>(const std::array<U, reads>& dimensions, const U& angle) {
            return U(sign * ram_velocity(Layout<Drive>::make(dimensions, motion.assembly), angle));
        };
        const auto plain = detail::plain_of(x);
        const CrankRange<double> range{false, value_of(part.from), value_of(part.to)};
        const auto inside = stationary_places<stationary_points>(
            ram_velocity_extremes(Layout<Drive>::make(plain, motion.assembly), range), 0.5 * (range.from + range.to),
            [&](double angle) { return forward(plain, angle); });
        speed[0] = sign * ram_velocity(m, part.from);
        speed[1] = sign * ram_velocity(m, part.to);
        for (std::size_t k = 0; k < stationary_points; ++k)
            speed[k + 2] = value_at(x, inside[k], forward);
        duration = part.to - part.from;
    }
};

/// The least speed on the working part, for unit crank speed.
template <template <class> class Drive>
struct RamSpeedMinWorking {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t most = WorkingSpeeds<Drive, double>::stationary_points + 2;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        const WorkingSpeeds<Drive, T> working(motion, x);
        std::copy(working.speed.begin(), working.speed.end(), out.begin());
        return most;
    }
};

/// Greatest less least speed on the working part over its mean in time, which is the length of the part over the time
/// that it takes.
template <template <class> class Drive>
struct SpeedVariation {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t speeds = WorkingSpeeds<Drive, double>::stationary_points + 2;
    static constexpr std::size_t most = speeds * (speeds - 1);
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        const WorkingSpeeds<Drive, T> working(motion, x);
        const T length = T(motion.settings[working_share]) * stroke(Layout<Drive>::make(x, motion.assembly));
        const T per_mean = working.duration / length;
        std::array<T, speeds> relative;
        for (std::size_t k = 0; k < speeds; ++k)
            relative[k] = working.speed[k] * per_mean;
        return differences(relative, out);
    }
};

/// Longest over shortest link: every ratio of two links.
template <template <class> class Drive>
struct LinkRatio {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t links = Layout<Drive>::links.size();
    static constexpr std::size_t most = links * (links - 1);
    template <class T>
    static std::size_t components(const Motion&, const std::array<T, reads>& x, Components<T> out) {
        std::size_t count = 0;
        for (const std::size_t longest : Layout<Drive>::links)
            for (const std::size_t shortest : Layout<Drive>::links)
                if (longest != shortest) out[count++] = x[longest] / x[shortest];
        return count;
    }
};

template <template <class> class Drive>
struct TotalLength {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t most = 1;
    template <class T>
    static std::size_t components(const Motion&, const std::array<T, reads>& x, Components<T> out) {
        out[0] = T(0);
        for (const std::size_t link : Layout<Drive>::links)
            out[0] += x[link];
        return most;
    }
};

}  // namespace mechwright::quick_return
