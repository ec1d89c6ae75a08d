#pragma once
/// \file
/// How something grows with something else.

#include <cmath>
#include <span>
#include <utility>

namespace mechwright::bench {

/// y = factor x^exponent.
struct Power {
    double exponent;
    double factor;

    double operator()(double x) const { return factor * std::pow(x, exponent); }
    /// The x that makes it so great.
    double at(double y) const { return std::pow(y / factor, 1 / exponent); }
};

/// The straight line through logarithms that leaves the least squares. Points that are not positive do not count; NaN
/// where fewer than two different x are left.
inline Power fitted_power(std::span<const std::pair<double, double>> points) {
    double count = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [at, value] : points) {
        if (!(at > 0 && value > 0)) continue;
        const double u = std::log(at), v = std::log(value);
        count += 1;
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    }
    const double exponent = (count * xy - x * y) / (count * xx - x * x);
    return {exponent, std::exp((y - exponent * x) / count)};
}

}  // namespace mechwright::bench
