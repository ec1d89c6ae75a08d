#pragma once
/// \file
/// Stationary points of a measure along a motion: every bracket found, each polished to rounding; and the derivatives
/// of the extreme value with respect to the design, by the envelope theorem.

#include <algorithm>
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
    const T one_unit = std::numeric_limits<T>::epsilon();
    const T floor = one_unit * abs(b - a);  // of the scale of a zero at zero itself, which has no relative rounding
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
        const T least = one_unit * (abs(best) > floor ? abs(best) : floor) / abs(b - a);
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

/// The dip of |g| around `middle`, where g has one sign at all three points and is least in size at the middle one:
/// reports the pair of zeros in it, if there is one. Parabolas through the lowest three points, until g changes sign or
/// |g| falls no more.
template <class Function, class Found>
void zeros_in_dip(const Function& g, double left, double middle, double right, double g_left, double g_middle,
                  double g_right, const Found& found) {
    const double start = left, end = right, g_start = g_left, g_end = g_right;
    for (int idle = 0; idle < 3;) {
        const double p = (middle - left) * (g_middle - g_right);
        const double q = (middle - right) * (g_middle - g_left);
        double x = middle - 0.5 * ((middle - left) * p - (middle - right) * q) / (p - q);
        if (!(x > left && x < right) || x == middle)
            x = 0.5 * (middle + (right - middle > middle - left ? right : left));
        const double gx = g(x);
        if ((gx > 0) != (g_middle > 0)) {
            found(zero_between<double>(g, start, x, g_start, gx));
            found(zero_between<double>(g, x, end, gx, g_end));
            return;
        }
        if (!(std::abs(gx) < 0.9 * std::abs(g_middle))) ++idle;
        if (std::abs(gx) < std::abs(g_middle)) {
            (x > middle ? left : right) = middle;
            (x > middle ? g_left : g_right) = g_middle;
            middle = x;
            g_middle = gx;
        } else {
            (x > middle ? right : left) = x;
            (x > middle ? g_right : g_left) = gx;
        }
    }
}

/// Reports to `found(x)` the zeros of `g` between neighbouring grid points, in increasing order: every change of sign,
/// and pairs of zeros between points where |g| dips without changing sign. Points where g is not finite bracket
/// nothing.
template <class Function, class Found>
void zeros_on_grid(const Function& g, std::span<const double> grid, const Found& found) {
    struct Sample {
        double x, g;
    };
    const auto sample = [&](double x) { return Sample{x, g(x)}; };
    const auto one_sign = [](const Sample& a, const Sample& b) {
        return std::isfinite(a.g) && std::isfinite(b.g) && a.g != 0 && b.g != 0 && (a.g > 0) == (b.g > 0);
    };
    if (grid.empty()) return;
    Sample before{}, last = sample(grid[0]);
    if (last.g == 0) found(last.x);
    for (std::size_t i = 1; i < grid.size(); ++i) {
        const Sample next = sample(grid[i]);
        if (next.g == 0) {
            found(next.x);
        } else if (std::isfinite(last.g) && std::isfinite(next.g) && last.g != 0 && (last.g > 0) != (next.g > 0)) {
            found(zero_between<double>(g, last.x, next.x, last.g, next.g));
        } else if (i >= 2 && one_sign(before, last) && one_sign(last, next) && std::abs(last.g) <= std::abs(before.g) &&
                   std::abs(last.g) <= std::abs(next.g)) {
            zeros_in_dip(g, before.x, last.x, next.x, before.g, last.g, next.g, found);
        }
        before = last;
        last = next;
    }
}

/// The value of a measure at a point where it is stationary in the last of N + 1 variables, as a function of the first
/// N: at such a point the first derivatives with respect to the design are the partial ones, and the second ones lose
/// f_iz f_jz / f_zz (envelope theorem, differentiated once more). Where f changes along z by rounding alone, as the
/// curvature along an arc does, every z is as good, and this one stays.
template <class T, std::size_t M>
SecondDual<T, M - 1> stationary_value(const SecondDual<T, M>& f) {
    using std::abs, std::max;
    constexpr std::size_t n = M - 1;
    constexpr double unchanged_within = 1e-12;
    T size = abs(f.value);
    for (std::size_t i = 0; i < n; ++i)
        size = max(size, T(abs(f.first[i])));
    const bool moves = abs(f.mixed(n, n)) > unchanged_within * size;
    SecondDual<T, n> r(f.value);
    for (std::size_t i = 0; i < n; ++i) {
        r.first[i] = f.first[i];
        for (std::size_t j = 0; j <= i; ++j) {
            T& second = r.second[i * (i + 1) / 2 + j];
            second = f.mixed(i, j);
            if (moves) second -= f.mixed(n, i) * f.mixed(n, j) / f.mixed(n, n);
        }
    }
    return r;
}

}  // namespace mechwright
