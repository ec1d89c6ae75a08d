#pragma once
/// \file
/// Crank angles that are whole right angles. In radians they are rounded, and next to a change point or a dead position
/// the root of that rounding counts: velocities lose half of their digits. These have the sine and cosine of the right
/// angles themselves.

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "analysis/four_bar/pose_formulas.h"
#include "analysis/geometry/vector.h"

namespace mechwright {

namespace detail {

/// How many right angles an angle (radians) is, counted within two turns, if it is a whole number of them but for the
/// rounding of a product.
inline std::optional<int> right_angles(double angle) {
    constexpr double right = std::numbers::pi / 2, most = 1e6;
    const double count = std::round(angle / right);
    const double one_unit = std::numeric_limits<double>::epsilon() * std::abs(angle);
    if (!(std::abs(count) < most) || !(std::abs(angle - count * right) <= one_unit)) return std::nullopt;
    return ((static_cast<int>(count) % 8) + 8) % 8;
}

}  // namespace detail

/// half_turn of a crank angle in radians.
inline HalfTurn<double> exact_half_turn(double crank_angle) {
    const auto count = detail::right_angles(crank_angle);
    if (!count) return half_turn(crank_angle);
    constexpr double r = std::numbers::sqrt2 / 2;
    constexpr std::array<HalfTurn<double>, 8> turns{
        {{1, 0}, {r, r}, {0, 1}, {-r, r}, {-1, 0}, {-r, -r}, {0, -1}, {r, -r}}};
    return turns[static_cast<std::size_t>(*count)];
}

/// Whether all links of a four-bar lie on the ground line, where two motions meet. Not where a kite has its pins
/// together: there rocker and coupler can turn by themselves.
inline bool is_change_point(const FourBarPose<double>& p) {
    return p.crank.y == 0 && p.margins.diagonal > 0 && (p.margins.stretch == 0 || p.margins.fold == 0);
}

/// The crank angle by which velocities are taken at a change point on a right angle, where they have limits from both
/// sides: the angle as it is rounded chooses one; at 0, which has no rounding, it is the one from above. Accelerations
/// vanish there: a linkage in one line moves like its mirror image, so that its angles are odd in the crank angle.
/// Taken by the rounded angle they would be rounding over rounding.
inline double beside_change_point(double crank_angle) {
    return crank_angle == 0 ? std::numeric_limits<double>::epsilon() / 2 : crank_angle;
}

/// The unit vector in the direction of an angle in radians.
inline Vector<double> exact_direction(double angle) {
    const auto count = detail::right_angles(angle);
    if (!count) return {std::cos(angle), std::sin(angle)};
    constexpr std::array<Vector<double>, 4> directions{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    return directions[static_cast<std::size_t>(*count) % 4];
}

}  // namespace mechwright
