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
#include <numbers>
#include <span>

#include "analysis/extremes.h"
#include "analysis/four_bar/limits.h"
#include "analysis/four_bar/velocity.h"

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

/// Crank angles at which the velocity ratio can be extreme, in increasing order.
struct VelocityRatioExtremes {
    static constexpr std::size_t most = 10;  ///< six stationary points, two ends, two to spare for rounding
    std::array<double, most> at{};
    std::size_t count = 0;

    void add(double angle) {
        if (count < most) at[count++] = angle;
    }
};

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

/// Crank angles close enough together to bracket all stationary points: their steps grow with the distance from the
/// singularities, as hyperbolic sines do.
class VelocityRatioGrid {
public:
    /// Precondition: to - from is little more than a turn, at most.
    VelocityRatioGrid(const FourBar<double>& m, double from, double to, bool ends_at_toggles) {
        constexpr double pi = std::numbers::pi;
        const std::array<double, 2> scale{fastest_scale(m, {1, 0}), fastest_scale(m, {0, 1})};
        const auto scale_at = [&](double turns) { return scale[std::fmod(turns, 2) == 0 ? 0 : 1]; };
        const auto scale_of_end = [&](double end) {
            const double turns = std::round(end / pi);
            const double surroundings = std::hypot(end - turns * pi, scale_at(turns));
            // At a toggle the ratio is infinite: much finer steps.
            return ends_at_toggles ? std::min(to - from, surroundings) / 32 : surroundings;
        };
        double left = from, left_scale = scale_of_end(from);
        const double first = std::floor(from / pi) + 1;
        for (double turns = first; turns < first + 3 && turns * pi < to; ++turns) {
            add_interval(left, turns * pi, left_scale, scale_at(turns));
            left = turns * pi;
            left_scale = scale_at(turns);
        }
        add_interval(left, to, left_scale, scale_of_end(to));
        add(to);
    }

    std::span<const double> angles() const { return {angles_.data(), count_}; }

private:
    void add(double angle) {
        if (count_ < angles_.size() && (count_ == 0 || angle > angles_[count_ - 1])) angles_[count_++] = angle;
    }

    /// Points from left (included) to right (not included).
    void add_interval(double left, double right, double left_scale, double right_scale) {
        constexpr double step = 0.5;
        const double half = 0.5 * (right - left);
        const auto steps = [&](double scale) { return std::ceil(std::asinh(half / scale) / step); };
        const double left_steps = steps(left_scale), right_steps = steps(right_scale);
        for (double i = 0; i < left_steps; ++i)
            add(left + left_scale * std::sinh(std::asinh(half / left_scale) * i / left_steps));
        for (double i = right_steps; i > 0; --i)
            add(right - right_scale * std::sinh(std::asinh(half / right_scale) * i / right_steps));
    }

    std::array<double, 640> angles_;
    std::size_t count_ = 0;
};

}  // namespace detail

/// All stationary points over a full turn (in [0, 2 pi)), or those inside a limited range, to rounding; a limited range
/// has its ends too. Of a range of more than a turn, the stationary points of the first turn are given.
/// Precondition: the linkage assembles over the whole motion, on one side of any toggle.
inline VelocityRatioExtremes velocity_ratio_extremes(const FourBar<double>& m, Assembly assembly,
                                                     const CrankRange<double>& range) {
    constexpr double turn = 2 * std::numbers::pi;
    VelocityRatioExtremes extremes;
    const auto slope = [&](double angle) { return velocity_ratio_slope(m, angle, assembly); };
    if (!range.full_turn) {
        const detail::VelocityRatioGrid grid(m, range.from, std::min(range.to, range.from + turn), true);
        extremes.add(range.from);
        zeros_on_grid(slope, grid.angles(), [&](double x) {
            if (x > range.from && x < range.to && extremes.count + 1 < VelocityRatioExtremes::most) extremes.add(x);
        });
        extremes.add(range.to);
        return extremes;
    }
    // One turn and a little more, so that the seam lies inside a bracket too. What the second look at the overlap finds
    // counts only where the first look found nothing near.
    constexpr double seam = -1, overlap = 0.125;
    const detail::VelocityRatioGrid grid(m, seam, seam + turn + overlap, false);
    zeros_on_grid(slope, grid.angles(), [&](double x) {
        const bool again = x >= seam + turn && extremes.count > 0 && extremes.at[0] < seam + 2 * overlap;
        if (!again) extremes.add(x);
    });
    for (std::size_t i = 0; i < extremes.count; ++i)
        if (extremes.at[i] < 0) extremes.at[i] += turn;
    std::sort(extremes.at.begin(), extremes.at.begin() + extremes.count);
    return extremes;
}

}  // namespace mechwright
