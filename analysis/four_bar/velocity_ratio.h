#pragma once
/// \file
/// The velocity ratio rocker/crank of a four-bar and its extremes over a motion: the crank angles at which the rocker
/// of a uniformly turning crank has no angular acceleration. There are at most six per turn and assembly: the poses
/// form a curve of genus one on which the ratio takes each value six times, complex poses counted, so that it is
/// stationary twelve times (Riemann-Hurwitz), in pairs mirrored about the ground line, one of each assembly.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "analysis/four_bar/limits.h"
#include "analysis/four_bar/velocity.h"
#include "analysis/numbers/graded_grid.h"

namespace mechwright {

/// Angular velocity of the rocker over that of the crank.
template <class T>
T velocity_ratio(const FourBar<T>& m, const T& crank_angle, Assembly assembly) {
    return velocity(m, pose(m, crank_angle, assembly)).rocker;
}

/// d(velocity ratio)/d(crank angle).
template <class T>
T velocity_ratio_slope(const FourBar<T>& m, const T& crank_angle, Assembly assembly) {
    const auto p = pose(m, crank_angle, assembly);
    return acceleration(m, p, velocity(m, p)).rocker;
}

/// The velocity ratio at a toggle: infinite, with the sign that it has close by. It has the sign of cross(coupler, e)
/// of the open linkage, e being the direction of the crank. With the dyad stretched, or folded and its coupler the
/// longer, the coupler points from the crank pin to the rocker pivot, folded with the rocker the longer away from it,
/// and cross(rocker pivot - crank pin, e) = ground sin(crank angle). Derivation.
inline double velocity_ratio_at_toggle(const FourBar<double>& m, double crank_angle, Assembly assembly) {
    const auto margins = assembly_margins(m, half_turn(crank_angle));
    const bool stretched = std::abs(margins.stretch) < std::abs(margins.fold);
    const bool towards_pivot = stretched || m.coupler >= m.rocker;
    const bool positive = (std::sin(crank_angle) > 0) == towards_pivot;
    const double infinity = std::numeric_limits<double>::infinity();
    return positive == (assembly == Assembly::open) ? infinity : -infinity;
}

/// Crank angles at which the velocity ratio can be extreme, in increasing order: six stationary points, two ends, two
/// to spare for rounding.
using VelocityRatioExtremes = CrankAngles<10>;

/// The velocity ratios from either side at a change point, where all pins are in one line with the crank away from the
/// rocker pivot or towards it: while one assembly is kept the rocker there goes on with another velocity. The diagonal
/// d from crank pin to rocker pivot turns by its own rate, and the rocker against it as the root of the squared area of
/// the triangle, 16 A^2 = ((coupler + rocker)^2 - d^2) (d^2 - (coupler - rocker)^2), one of whose factors is ground
/// crank times the square of the crank's way from there. Derivation.
template <class T>
std::array<T, 2> velocity_ratios_at_change_point(const FourBar<T>& m, bool away) {
    using std::abs, std::sqrt;
    const T diagonal = away ? T(m.ground + m.crank) : T(m.ground - m.crank);
    const T own = (away ? m.crank : T(-m.crank)) / diagonal;
    const T sum = m.coupler + m.rocker, difference = m.coupler - m.rocker;
    const T other = away ? T(diagonal * diagonal - difference * difference) : T(sum * sum - diagonal * diagonal);
    const T against = sqrt(T(m.ground * m.crank * other)) / (T(2) * m.rocker * abs(diagonal));
    return {own - against, own + against};
}

namespace detail {

/// How far, in radians, the nearest singularity of the pose lies from the crank on the ground line (0 or pi): the
/// complex crank angles at which the diagonal or the area of the dyad vanishes. The ratio changes no faster than on
/// this scale.
inline double fastest_scale(const FourBar<double>& m, const HalfTurn<double>& on_ground_line) {
    const auto margins = assembly_margins(m, on_ground_line);
    const auto k = dyad(m, margins);
    const double square = std::min({margins.diagonal * margins.diagonal, std::abs(k.stretched), std::abs(k.folded)});
    return std::max(2 * std::asinh(std::sqrt(square / (4 * m.ground * m.crank))), 1e-12);
}

}  // namespace detail

/// All stationary points over a full turn (in [0, 2 pi)), or those inside a limited range, to rounding; a limited range
/// has its ends too. Of a range of more than a turn, the stationary points of the first turn are given.
/// Precondition: the linkage assembles over the whole motion, on one side of any toggle.
inline VelocityRatioExtremes velocity_ratio_extremes(const FourBar<double>& m, Assembly assembly,
                                                     const CrankRange<double>& range) {
    const std::array<FastPlace, 2> places{
        {{0, detail::fastest_scale(m, {1, 0})}, {std::numbers::pi, detail::fastest_scale(m, {0, 1})}}};
    const auto slope = [&](double angle) { return velocity_ratio_slope(m, angle, assembly); };
    // The ends of a limited range can be toggles, where the ratio is infinite: there, finer steps.
    const auto inside = zeros_of_motion<VelocityRatioExtremes::capacity>(
        slope, places, range, {.end_part = range.full_turn ? 1.0 : 1.0 / 32});
    if (range.full_turn) return inside;
    VelocityRatioExtremes extremes;
    extremes.add(range.from);
    for (std::size_t i = 0; i < inside.count && i + 2 < VelocityRatioExtremes::capacity; ++i)
        extremes.add(inside.at[i]);
    extremes.add(range.to);
    return extremes;
}

}  // namespace mechwright
