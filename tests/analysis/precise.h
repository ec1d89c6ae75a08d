#pragma once
/// \file
/// The fifty-digit arithmetic that tests compare against, central differences in it, and how digits are counted.

#include <algorithm>
#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <cstddef>

#include "analysis/four_bar/four_bar.h"
#include "tests/degree.h"

namespace mechwright::test {

using Precise =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

inline FourBar<Precise> precise(const FourBar<double>& m) { return converted<Precise>(m); }

/// Correct decimal digits of `value` relative to `scale` (of `exact` itself if no scale is given), 17 at most.
inline double digits(double value, const Precise& exact, const Precise& scale) {
    const double error = static_cast<double>(abs(Precise(value) - exact) / abs(scale));
    if (!(error >= 0)) return error == 0 || exact == Precise(value) ? 17 : -1;
    return error == 0 ? 17 : std::clamp(-std::log10(error), -1.0, 17.0);
}

inline double digits(double value, const Precise& exact) { return digits(value, exact, exact); }

template <std::size_t N>
using Point = std::array<Precise, N>;

template <std::size_t N>
Point<N> precise(const std::array<double, N>& x) {
    Point<N> p;
    std::copy(x.begin(), x.end(), p.begin());
    return p;
}

/// First and second derivatives of `f` at a point by central differences. With steps of 1e-13 of the size given both
/// the truncation (about 1e-26) and the rounding (about 1e-24) stay far below the rounding of double.
template <std::size_t N>
struct Derivatives {
    Precise value;
    std::array<Precise, N> gradient;
    std::array<std::array<Precise, N>, N> hessian;
};

template <std::size_t N, class Function>
Derivatives<N> central_differences(const Function& f, const Point<N>& at, const Precise& size) {
    const Precise h = size * Precise(1e-13);
    const auto moved = [&](std::size_t i, int di, std::size_t j, int dj) {
        Point<N> x = at;
        x[i] += di * h;
        x[j] += dj * h;
        return Precise(f(x));
    };
    Derivatives<N> d;
    d.value = f(at);
    std::array<Precise, N> up, down;
    for (std::size_t i = 0; i < N; ++i) {
        up[i] = moved(i, 1, i, 0);
        down[i] = moved(i, -1, i, 0);
        d.gradient[i] = (up[i] - down[i]) / (2 * h);
        d.hessian[i][i] = (up[i] - 2 * d.value + down[i]) / (h * h);
    }
    // f_ij from the two diagonal neighbours: f(++) + f(--) = 2 f + h^2 (f_ii + 2 f_ij + f_jj).
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Precise both = moved(i, 1, j, 1) + moved(i, -1, j, -1);
            d.hessian[i][j] = (both + 2 * d.value - up[i] - down[i] - up[j] - down[j]) / (2 * h * h);
            d.hessian[j][i] = d.hessian[i][j];
        }
    return d;
}

}  // namespace mechwright::test
