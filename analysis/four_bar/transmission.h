#pragma once
/// \file
/// The transmission angle between coupler and rocker and its extremes over the motion. It depends on the diagonal alone
/// and grows with it, so that over a full turn its extremes are at crank angles 0 and pi, and over a limited range at
/// the ends and at whichever of 0, pi lies inside. Reference: Theory of Machines, equation (2-1), in half angles.

#include <array>
#include <cstddef>
#include <numbers>

#include "analysis/four_bar/limits.h"

namespace mechwright {

/// Transmission angle in [0, pi] where the linkage assembles; 0 or pi beyond a toggle.
template <class T>
T transmission_angle(const FourBar<T>& m, const HalfTurn<T>& half) {
    const auto margins = assembly_margins(m, half);
    const auto k = detail::dyad(m, margins);
    return angle(HalfAngle<T>{root_or_zero(k.folded), root_or_zero(k.stretched)});
}

/// Whether the linkage has a toggle at a crank angle, but for the rounding of that angle.
template <class T>
bool is_toggle(const FourBar<T>& m, const HalfTurn<T>& half) {
    constexpr double toggle_within = 2e-15;
    const auto margins = assembly_margins(m, half);
    const double size = static_cast<double>(value_of(m.ground + m.crank + m.coupler + m.rocker));
    return std::abs(value_of(margins.stretch)) < toggle_within * size ||
           std::abs(value_of(margins.fold)) < toggle_within * size;
}

/// The transmission angle at an end of a limited range. A toggle at the end counts as one in spite of the rounding of
/// its crank angle, by which half of the digits would be lost.
template <class T>
T transmission_angle_at_end(const FourBar<T>& m, const HalfTurn<T>& half) {
    if (!is_toggle(m, half)) return transmission_angle(m, half);
    const auto margins = assembly_margins(m, half);
    return std::abs(value_of(margins.stretch)) < std::abs(value_of(margins.fold)) ? T(std::numbers::pi) : T(0);
}

/// The crank angles, as half turns, at which the transmission angle can have an extreme over a motion.
struct TransmissionExtremes {
    std::array<HalfTurn<double>, 4> at{};
    std::size_t count = 0;
};

/// For a full turn: 0, where the angle is least, then pi, where it is greatest.
inline TransmissionExtremes transmission_extremes_of_full_turn() { return {{{{1, 0}, {0, 1}}}, 2}; }

/// For a limited range from <= to (radians): both ends, then 0 and pi if a full multiple lies strictly inside.
inline TransmissionExtremes transmission_extremes(double from, double to) {
    TransmissionExtremes e;
    e.at[e.count++] = half_turn(from);
    e.at[e.count++] = half_turn(to);
    const auto inside = [&](double offset) {  // is some offset + 2 pi k inside?
        constexpr double turn = 2 * std::numbers::pi;
        const double first = offset + turn * (std::floor((from - offset) / turn) + 1);
        return first < to;
    };
    if (inside(0)) e.at[e.count++] = {1, 0};
    if (inside(std::numbers::pi)) e.at[e.count++] = {0, 1};
    return e;
}

}  // namespace mechwright
