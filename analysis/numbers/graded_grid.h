#pragma once
/// \file
/// Crank angles at which a motion is sampled to bracket the zeros of its slopes. A mechanism moves fast only near
/// certain crank angles, where a complex crank angle close by makes its formulas singular; the steps of the grid grow
/// from there with the distance, as hyperbolic sines do.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>

#include "analysis/geometry/crank_range.h"
#include "analysis/numbers/extremes.h"

namespace mechwright {

/// A crank angle with fast motion, known but for whole turns, and how far (in radians) from it the singularity lies.
struct FastPlace {
    double angle;
    double scale;
};

class GradedGrid {
public:
    struct Steps {
        /// In units of the inverse hyperbolic sine.
        double graded = 0.5;
        /// Radians.
        double widest = std::numeric_limits<double>::infinity();
        /// The part of the usual scale that is taken at both ends: less where the motion is singular there.
        double end_part = 1;
    };

    /// Precondition: to - from is little more than a turn, at most; at most eight places.
    GradedGrid(std::span<const FastPlace> places, double from, double to, const Steps& steps) : steps_(steps) {
        constexpr double turn = 2 * std::numbers::pi;
        std::array<FastPlace, 32> inside;
        std::size_t count = 0;
        for (const FastPlace& place : places)
            for (double k = std::floor((from - place.angle) / turn) + 1; place.angle + k * turn < to; ++k)
                if (count < inside.size()) inside[count++] = {place.angle + k * turn, scale_at(places, place.angle)};
        std::sort(inside.begin(), inside.begin() + count,
                  [](const auto& a, const auto& b) { return a.angle < b.angle; });
        const auto end = [&](double angle) {
            return FastPlace{angle, floored(steps.end_part * std::min(scale_at(places, angle), to - from))};
        };
        FastPlace left = end(from);
        for (std::size_t i = 0; i < count; ++i) {
            add_interval(left, inside[i]);
            left = inside[i];
        }
        add_interval(left, end(to));
        add(to);
    }

    /// Increasing, both ends included.
    std::span<const double> angles() const { return {angles_.data(), count_}; }

private:
    static double floored(double scale) { return scale > 1e-12 ? scale : 1e-12; }  // NaN too

    /// How far the nearest singularity is: a place close by can be the faster one.
    static double scale_at(std::span<const FastPlace> places, double angle) {
        constexpr double turn = 2 * std::numbers::pi;
        double least = turn;
        for (const FastPlace& place : places)
            least = std::min(least, std::hypot(std::remainder(angle - place.angle, turn), place.scale));
        return floored(least);
    }

    void add(double angle) {
        if (count_ < angles_.size() && (count_ == 0 || angle > angles_[count_ - 1])) angles_[count_++] = angle;
    }

    /// Points from left (included) to right (not included).
    void add_interval(const FastPlace& left, const FastPlace& right) {
        const double half = 0.5 * (right.angle - left.angle);
        const auto steps = [&](double scale) {
            return std::ceil(std::max(std::asinh(half / scale) / steps_.graded, half / steps_.widest));
        };
        const auto distance = [&](double scale, double part) {
            return scale * std::sinh(std::asinh(half / scale) * part);
        };
        const double left_steps = steps(left.scale), right_steps = steps(right.scale);
        for (double i = 0; i < left_steps; ++i)
            add(left.angle + distance(left.scale, i / left_steps));
        for (double i = right_steps; i > 0; --i)
            add(right.angle - distance(right.scale, i / right_steps));
    }

    Steps steps_;
    std::array<double, 1536> angles_;
    std::size_t count_ = 0;
};

/// Crank angles in increasing order; what does not fit is left out.
template <std::size_t most>
struct CrankAngles {
    static constexpr std::size_t capacity = most;
    std::array<double, most> at{};
    std::size_t count = 0;

    void add(double angle) {
        if (count < most) at[count++] = angle;
    }
    std::span<const double> all() const& { return {at.data(), count}; }
    std::span<const double> all() const&& = delete;  // they would be gone
};

/// The zeros of a function of the crank angle inside a motion, to rounding: over a full turn those in [0, 2 pi), else
/// those strictly between the ends (of a range of more than a turn, in its first turn).
template <std::size_t most, class Function>
CrankAngles<most> zeros_of_motion(const Function& g, std::span<const FastPlace> places, const CrankRange<double>& range,
                                  const GradedGrid::Steps& steps) {
    constexpr double turn = 2 * std::numbers::pi;
    CrankAngles<most> zeros;
    if (!range.full_turn) {
        const double to = std::min(range.to, range.from + turn);
        const GradedGrid grid(places, range.from, to, steps);
        zeros_on_grid(g, grid.angles(), [&](double x) {
            if (x > range.from && x < to) zeros.add(x);
        });
        return zeros;
    }
    // One turn and a little more, so that the seam lies inside a bracket too. What the second look at the overlap finds
    // counts only where the first look found nothing near.
    constexpr double seam = -1, overlap = 0.125;
    const GradedGrid grid(places, seam, seam + turn + overlap, steps);
    zeros_on_grid(g, grid.angles(), [&](double x) {
        const bool again = x >= seam + turn && zeros.count > 0 && zeros.at[0] < seam + 2 * overlap;
        if (!again) zeros.add(x);
    });
    for (std::size_t i = 0; i < zeros.count; ++i)
        if (zeros.at[i] < 0) zeros.at[i] += turn;
    std::sort(zeros.at.begin(), zeros.at.begin() + zeros.count);
    return zeros;
}

}  // namespace mechwright
