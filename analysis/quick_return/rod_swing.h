#pragma once
/// \file
/// Where the rod of a drive stops turning against the slide, over a full turn of the crank: there its slope and with it
/// the transmission angle at the ram is extreme. All crank angles in radians.

#include <array>
#include <numbers>

#include "analysis/quick_return/ram.h"

namespace mechwright {

/// Crank square to the slide, to its left, then to its right.
inline std::array<double, 2> rod_turning_points(const SliderCrank<double>&) {
    return {std::numbers::pi / 2, -std::numbers::pi / 2};
}

/// Arm square to the slide, to its left (slot to its right), then the other way round.
inline std::array<double, 2> rod_turning_points(const Whitworth<double>& m) {
    return {crank_angle_at_slot(m, m.slide_angle - std::numbers::pi / 2),
            crank_angle_at_slot(m, m.slide_angle + std::numbers::pi / 2)};
}

/// Arm square to the slide, to its left, then to its right.
inline std::array<double, 2> rod_turning_points(const DragLink<double>& m) {
    const auto crank_at = [&](double arm) {
        const Vector<double> crank = crank_direction_at_follower(m, arm + m.slide_angle - m.arm_angle);
        return std::atan2(crank.y, crank.x);
    };
    return {crank_at(std::numbers::pi / 2), crank_at(-std::numbers::pi / 2)};
}

/// Lever upright, twice, and both ends of its swing.
inline std::array<double, 4> rod_turning_points(const CrankShaper<double>& m) {
    const double end = 0.5 * strokes(m).outward;
    return {0, std::numbers::pi, end, -end};
}

}  // namespace mechwright
