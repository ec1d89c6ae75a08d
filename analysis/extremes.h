#pragma once
/// \file
/// Stationary points of a measure along a motion: every bracket found, each polished to rounding; and the derivatives of
/// the extreme value with respect to the design, by the envelope theorem.

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "analysis/numbers/second_dual.h"

namespace mechwright {

/// A zero of `g` between a and b, where g changes sign from ga to gb, to the rounding of T. Method of Chandrupatla
/// (Advances in Engineering Software 28, 1997): inverse quadratic interpolation where it is safe, else bisection.
template <class T, class Function>
T zero_between(const Function& g, T a, T b, T ga, T gb) {
    using std::abs;
    const T rounding = std::numeric_limits<T>::epsilon();
    T c = a, gc = ga;
    T t(0.5);
    while (true) {
        const T x = a + t * (b - a);
        const T gx = g(x);
        if ((gx > T(0)) == (ga > T(0))) {
            c = a;
            gc = ga;
        } else {
            c = b;
            gc = gb;
            b = a;
            gb = ga;
        }
        a = x;
        ga = gx;
        const T best = abs(ga) < abs(gb) ? a : b;
        const T least = rounding * abs(best) / abs(b - a);
        if (ga == T(0) || !(least < T(0.5))) return best;
        const T xi = (a - b) / (c - b);
        const T phi = (ga - gb) / (gc - gb);
        if (phi * phi < xi && (T(1) - phi) * (T(1) - phi) < T(1) - xi)
            t = (ga / (gb - ga)) * (gc / (gb - gc)) + ((c - a) / (b - a)) * (ga / (gc - ga)) * (gb / (gc - gb));
        else
            t = T(0.5);
        if (t < least) t = least;
        if (t > T(1) - least) t = T(1) - least;
    }
}

/// Reports to `found(x)` the zeros of `g` between neighbouring grid points (increasing): every change of sign, and pairs
/// of zeros between points where |g| dips without changing sign.
template <class Function, class Found>
void zeros_on_grid(const Function& g, std::span<const double> grid, const Found& found) {
    if (grid.size() < 2) return;
    const auto between = [&](double a, double b, double ga, double gb) {
        if (ga == 0) return;  // reported as the end of the interval before, or as a grid point
        if (gb == 0)
            found(b);
        else if ((ga > 0) != (gb > 0))
            found(zero_between<double>(g, a, b, ga, gb));
    };
    double x0 = grid[0], x1 = grid[1];
    double g0 = g(x0), g1 = g(x1);
    if (g0 == 0) found(x0);
    between(x0, x1, g0, g1);
    for (std::size_t i = 2; i < grid.size(); ++i) {
        const double x2 = grid[i];
        const double g2 = g(x2);
        const bool one_sign = (g0 > 0) == (g1 > 0) && (g1 > 0) == (g2 > 0) && g1 != 0;
        if (one_sign && std::abs(g1) <= std::abs(g0) && std::abs(g1) <= std::abs(g2)) {
            // Golden-section descent on |g| until it changes sign or the dip is resolved.
            constexpr double golden = 0.3819660112501051;
            double left = x0, middle = x1, right = x2, lowest = std::abs(g1);
            for (int k = 0; k < 60; ++k) {
                const bool right_wider = right - middle > middle - left;
                const double x = right_wider ? middle + golden * (right - middle) : middle - golden * (middle - left);
                const double gx = g(x);
                if ((gx > 0) != (g1 > 0)) {
                    found(zero_between<double>(g, x0, x, g0, gx));
                    found(zero_between<double>(g, x, x2, gx, g2));
                    break;
                }
                if (std::abs(gx) < lowest) {
                    (right_wider ? left : right) = middle;
                    middle = x;
                    lowest = std::abs(gx);
                } else {
                    (right_wider ? right : left) = x;
                }
            }
        }
        between(x1, x2, g1, g2);
        x0 = x1;
        g0 = g1;
        x1 = x2;
        g1 = g2;
    }
}

/// The value of a measure at a point where it is stationary in the last of N + 1 variables, as a function of the first
/// N: at such a point the first derivatives with respect to the design are the partial ones, and the second ones lose
/// f_iz f_jz / f_zz (envelope theorem, differentiated once more).
template <class T, std::size_t M>
SecondDual<T, M - 1> stationary_value(const SecondDual<T, M>& f) {
    constexpr std::size_t n = M - 1;
    SecondDual<T, n> r(f.value);
    for (std::size_t i = 0; i < n; ++i) {
        r.first[i] = f.first[i];
        for (std::size_t j = 0; j <= i; ++j)
            r.second[i * (i + 1) / 2 + j] = f.mixed(i, j) - f.mixed(n, i) * f.mixed(n, j) / f.mixed(n, n);
    }
    return r;
}

}  // namespace mechwright
