#pragma once
/// \file
/// The transmission angles of ram-driving mechanisms as smooth components: at the ram, a right angle less the slope of
/// the rod; for the drag link also between coupler and follower.

#include <array>
#include <cstddef>

#include "synthesis/mechanism/four_bar/formulas.h"
#include "synthesis/mechanism/quick_return/ram_extreme_places.h"

namespace mechwright::quick_return {

namespace detail {

/// The angle whose cosine is 1 - margin / rod, margin in [0, 2 rod].
template <class T>
T angle_at_ram(const T& margin, const T& rod) {
    return angle(half_angle_of_squares(margin, T(T(2) * rod - margin)));
}

/// Transmission angles at the ram over a full turn, seen from one side of the rod: the least one, and for an arm that
/// turns fully the least one seen from the other side. An angle beyond a right one is not the least of the two.
template <template <class> class Drive, class T>
std::array<T, 2> least_at_ram(const Drive<T>& m) {
    const std::array<T, 2> margins = Layout<Drive>::least_rod_margins(m);
    const T rod = output_of(m).rod;
    return {angle_at_ram(margins[0], rod), angle_at_ram(margins[1], rod)};
}

/// The greatest angle at the ram over a full turn: a right angle where the rod comes to lie along the slide. Each of
/// the two least ones above lies that far from it which its slope is; beyond a right angle the slope has the other
/// sign.
template <template <class> class Drive, class T>
T greatest_at_ram(const Drive<T>& m) {
    const std::array<T, 2> least = least_at_ram(m);
    const T right_angle(0.5 * pi<double>());
    if (least[0] > right_angle) return T(2) * right_angle - least[0];
    if (least[1] > right_angle) return T(2) * right_angle - least[1];
    return right_angle;
}

inline constexpr std::size_t turning_points = 4;
inline constexpr std::size_t limited_places = turning_points + 2;

/// Over a limited motion: at both ends and where the rod stops turning.
template <template <class> class Drive, class T>
std::size_t at_ram_in_range(const Motion& motion, const std::array<T, Layout<Drive>::reads>& x, Components<T> out,
                            const Ends<T>& ends) {
    constexpr std::size_t reads = Layout<Drive>::reads;
    const auto angle_at = [&]<class U>(const std::array<U, reads>& dimensions, const U& crank_angle) {
        return transmission_angle(ram_of(pose_at(Layout<Drive>::make(dimensions, motion.assembly), crank_angle)));
    };
    const Drive<double> plain = converted<double>(Layout<Drive>::make(x, motion.assembly));
    const auto slope = [&](double crank_angle) { return ram_of(pose_at(plain, crank_angle)).rod.y; };
    const auto inside = stationary_places<turning_points>(rod_extremes(plain, range_of(motion)), motion.from, slope);
    out[0] = rod_is_square(plain, motion.from) ? T(0) : angle_at(x, ends.from);
    out[1] = rod_is_square(plain, motion.to) ? T(0) : angle_at(x, ends.to);
    for (std::size_t k = 0; k < turning_points; ++k)
        out[k + 2] = value_at(x, inside[k], angle_at, ends);
    return limited_places;
}

/// Whether the rod lies along the slide somewhere in a limited motion.
template <template <class> class Drive>
bool rod_along_slide(const Motion& motion, const Drive<double>& plain) {
    const auto slope = [&](double crank_angle) { return ram_of(pose_at(plain, crank_angle)).rod.y; };
    const auto inside = stationary_places<turning_points>(rod_extremes(plain, range_of(motion)), motion.from, slope);
    double least = std::min(slope(motion.from), slope(motion.to));
    double greatest = std::max(slope(motion.from), slope(motion.to));
    for (const RamPlace& place : inside) {
        least = std::min(least, slope(place.angle));
        greatest = std::max(greatest, slope(place.angle));
    }
    return least <= 0 && greatest >= 0;
}

/// Components of the four-bar at the input of a drag link, by one of the four-bar's own formulas; none for the others.
template <template <class> class Drive, class Formula, class T>
std::size_t of_four_bar(const Motion& motion, const std::array<T, Layout<Drive>::reads>& x, Components<T> out) {
    if constexpr (HasFourBar<Drive<double>>)
        return Formula::template components<T>(motion, {x[0], x[1], x[2], x[3]}, out);
    else
        return 0;
}

template <template <class> class Drive, class T>
std::size_t least_over(const Motion& motion, const std::array<T, Layout<Drive>::reads>& x, Components<T> out) {
    if (motion.family != full_turn) return at_ram_in_range<Drive>(motion, x, out, fixed_ends<T>(motion));
    const std::array<T, 2> least = least_at_ram(Layout<Drive>::make(x, motion.assembly));
    std::copy(least.begin(), least.end(), out.begin());
    return least.size();
}

}  // namespace detail

/// The least angles at the ram, then what is `OfFourBar` of the four-bar at the input of a drive that has one.
template <template <class> class Drive, class OfFourBar>
struct LeastTransmissionAngle {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t most = detail::limited_places + OfFourBar::most;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        const std::size_t count = detail::least_over<Drive>(motion, x, out);
        return count + detail::of_four_bar<Drive, OfFourBar>(motion, x, out.subspan(count));
    }
};

template <template <class> class Drive>
using TransmissionAngleMin = LeastTransmissionAngle<Drive, four_bar::TransmissionAngleMin>;

/// The angle at the ram never exceeds a right one, so that its supplement is no worse.
template <template <class> class Drive>
using TransmissionAngleWorst = LeastTransmissionAngle<Drive, four_bar::TransmissionAngleWorst>;

template <template <class> class Drive>
struct TransmissionAngleMax {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t most = detail::limited_places + four_bar::TransmissionAngleMax::most;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        return components(motion, x, out, fixed_ends<T>(motion));
    }

    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out,
                                  const Ends<T>& ends) {
        const auto m = Layout<Drive>::make(x, motion.assembly);
        std::size_t count = 1;
        if (motion.family == full_turn) {
            out[0] = detail::greatest_at_ram(m);
        } else {
            count = detail::at_ram_in_range<Drive>(motion, x, out, ends);
            if (detail::rod_along_slide<Drive>(motion, converted<double>(m))) out[0] = T(0.5 * pi<double>());
        }
        return count + detail::of_four_bar<Drive, four_bar::TransmissionAngleMax>(motion, x, out.subspan(count));
    }
};

/// What must be >= 0 for a drive to work over its motion: over a full turn the conditions of a crank shaper that are
/// not linear in its dimensions; over a limited motion the margins of the rod wherever they can be least, and those of
/// the four-bar of a drag link.
template <template <class> class Drive>
struct AssemblyMargin {
    static constexpr std::size_t reads = Layout<Drive>::reads;
    static constexpr std::size_t most = 2 * detail::limited_places + four_bar::AssemblyMargin::most;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        const auto m = Layout<Drive>::make(x, motion.assembly);
        if constexpr (requires { Layout<Drive>::conditions_of_full_turn(m); }) {
            if (motion.family == full_turn) {
                const auto margins = Layout<Drive>::conditions_of_full_turn(m);
                std::copy(margins.begin(), margins.end(), out.begin());
                return margins.size();
            }
        }
        const Drive<double> plain = converted<double>(m);
        const auto slope = [&](double crank_angle) { return ram_of(pose_at(plain, crank_angle)).rod.y; };
        const auto inside =
            stationary_places<detail::turning_points>(rod_extremes(plain, range_of(motion)), motion.from, slope);
        std::size_t count = 0;
        const auto left = [&]<class U>(const std::array<U, reads>& dimensions, const U& crank_angle) {
            return ram_of(pose_at(Layout<Drive>::make(dimensions, motion.assembly), crank_angle)).left;
        };
        const auto right = [&]<class U>(const std::array<U, reads>& dimensions, const U& crank_angle) {
            return ram_of(pose_at(Layout<Drive>::make(dimensions, motion.assembly), crank_angle)).right;
        };
        const auto add = [&](const RamPlace& place) {
            out[count++] = value_at(x, place, left);
            out[count++] = value_at(x, place, right);
        };
        add({motion.from, false});
        add({motion.to, false});
        for (const RamPlace& place : inside)
            add(place);
        return count + detail::of_four_bar<Drive, four_bar::AssemblyMargin>(motion, x, out.subspan(count));
    }
};

}  // namespace mechwright::quick_return
