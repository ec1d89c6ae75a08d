#pragma once
/// \file
/// Nodes for integrals over [0, 1] to rounding, for functions with square roots at either end and with all but kinks
/// between: a mechanism that comes out of a dead position has the former, and one that passes close by a change point
/// the latter.

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <cstddef>
#include <span>

namespace mechwright {

/// Intervals of s, where share = s^2 (3 - 2 s): roots at both ends are smooth in s.
struct ResolvedIntervals {
    struct Interval {
        double from;
        double to;
    };
    std::array<Interval, 256> at;
    std::size_t count = 0;
};

/// Calls use(share, weight, gauss_weight) with the nodes of Gauss and Kronrod's rule of 21 points in an interval of s;
/// the last weight is that of the rule of 10 points among them, or 0.
template <class Use>
void for_each_kronrod_node(const ResolvedIntervals::Interval& interval, const Use& use) {
    using Kronrod = boost::math::quadrature::gauss_kronrod<double, 21>;
    using Gauss = boost::math::quadrature::gauss<double, 10>;
    const double middle = 0.5 * (interval.from + interval.to), half = 0.5 * (interval.to - interval.from);
    const auto at = [&](double s, double weight, double gauss_weight) {
        const double speed = 6 * s * (1 - s) * half;
        use(s * s * (3 - 2 * s), weight * speed, gauss_weight * speed);
    };
    // The abscissas from the middle outwards; those of Gauss's rule are every other one, of an even number of points.
    for (std::size_t k = 0; k < Kronrod::abscissa().size(); ++k) {
        const double x = Kronrod::abscissa()[k], weight = Kronrod::weights()[k];
        const double gauss_weight = k % 2 == 1 ? Gauss::weights()[k / 2] : 0;
        at(middle + half * x, weight, gauss_weight);
        if (k > 0) at(middle - half * x, weight, gauss_weight);
    }
}

/// Intervals in which both rules agree on the integrals of the square of a function and of its slope: `function(share)`
/// gives value and slope. What rounding alone makes of values of the size `scale` is let pass.
template <class Function>
ResolvedIntervals resolved_intervals(const Function& function, double scale) {
    // The rule of 21 points is then right to about the square of this.
    constexpr double agree_within = 1e-9, last_digits = 1e-14, narrowest = 1e-10;
    const auto resolved = [&](const ResolvedIntervals::Interval& interval) {
        double slope_apart = 0, slope_size = 0, square_apart = 0, square = 0, size = 0;
        for_each_kronrod_node(interval, [&](double share, double weight, double gauss_weight) {
            const auto [value, slope] = function(share);
            slope_apart += (weight - gauss_weight) * slope;
            slope_size += weight * std::abs(slope);
            square_apart += (weight - gauss_weight) * value * value;
            square += weight * value * value;
            size += weight * std::abs(value);
        });
        // Where the mechanism does not assemble there is nothing to resolve.
        if (!std::isfinite(square) || !std::isfinite(slope_size)) return true;
        return std::abs(slope_apart) <= agree_within * (slope_size + scale * (interval.to - interval.from)) &&
               std::abs(square_apart) <= agree_within * square + last_digits * scale * size;
    };
    ResolvedIntervals out, open;
    open.at[open.count++] = {0.5, 1};
    open.at[open.count++] = {0, 0.5};
    while (open.count > 0) {
        const auto now = open.at[--open.count];
        const double middle = 0.5 * (now.from + now.to);
        const bool room = out.count + open.count + 2 <= out.at.size();
        if (!room || now.to - now.from < narrowest || resolved(now)) {
            out.at[out.count++] = now;
        } else {
            open.at[open.count++] = {middle, now.to};
            open.at[open.count++] = {now.from, middle};
        }
    }
    return out;
}

}  // namespace mechwright
