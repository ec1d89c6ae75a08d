#pragma once
/// \file
/// The velocity ratio rocker/crank of a four-bar and its extremes over a motion: the crank angles at which the rocker of
/// a uniformly turning crank has no angular acceleration (Freudenstein 1956; at most six per turn and assembly).

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

/// Crank angles close enough together to bracket all stationary points: even steps, and steps that shrink by halves
/// towards 0 and pi, where a linkage close to a change point has its fast motion.
inline std::span<const double> velocity_ratio_grid() {
    static const auto grid = [] {
        std::array<double, 2 * 48 + 4 * 34> angles{};
        std::size_t n = 0;
        constexpr double pi = std::numbers::pi;
        for (int i = 0; i < 96; ++i)
            angles[n++] = (i + 0.5) * pi / 48;
        double step = pi / 96;
        for (int i = 0; i < 34; ++i, step /= 2)
            for (const double x : {step * 0.61, pi - step * 0.61, pi + step * 0.61, 2 * pi - step * 0.61})
                angles[n++] = x;
        std::sort(angles.begin(), angles.end());
        return angles;
    }();
    return grid;
}

}  // namespace detail

/// All stationary points over a full turn (in [0, 2 pi)), or those inside a limited range, to rounding; a limited range
/// has its ends too. Precondition: the linkage assembles over the whole motion, on one side of any toggle.
inline VelocityRatioExtremes velocity_ratio_extremes(const FourBar<double>& m, Assembly assembly,
                                                     const CrankRange<double>& range) {
    VelocityRatioExtremes extremes;
    const auto slope = [&](double angle) { return velocity_ratio_slope(m, angle, assembly); };
    const auto grid = detail::velocity_ratio_grid();
    if (range.full_turn) {
        // One turn and a little more, so that the interval over the seam is a bracket too.
        std::array<double, 256> turn{};
        std::copy(grid.begin(), grid.end(), turn.begin());
        turn[grid.size()] = grid[0] + 2 * std::numbers::pi;
        turn[grid.size() + 1] = grid[1] + 2 * std::numbers::pi;
        std::array<double, VelocityRatioExtremes::most + 4> found{};
        std::size_t n = 0;
        zeros_on_grid(slope, std::span<const double>(turn.data(), grid.size() + 2), [&](double x) {
            if (n < found.size()) found[n++] = x >= 2 * std::numbers::pi ? x - 2 * std::numbers::pi : x;
        });
        std::sort(found.begin(), found.begin() + n);
        for (std::size_t i = 0; i < n; ++i)
            if (i == 0 || found[i] > found[i - 1]) extremes.add(found[i]);
        return extremes;
    }
    std::array<double, 256> inside{};
    std::size_t n = 0;
    inside[n++] = range.from;
    const double turn = 2 * std::numbers::pi;
    const double whole = std::floor(range.from / turn) * turn;
    for (double base = whole; base < range.to; base += turn)
        for (const double x : grid)
            if (base + x > range.from && base + x < range.to && n + 1 < inside.size()) inside[n++] = base + x;
    inside[n++] = range.to;
    extremes.add(range.from);
    zeros_on_grid(slope, std::span<const double>(inside.data(), n), [&](double x) { extremes.add(x); });
    extremes.add(range.to);
    return extremes;
}

}  // namespace mechwright
