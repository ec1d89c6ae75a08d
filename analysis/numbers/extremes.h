#pragma once
/// \file
/// Stationary points of a measure along a motion: every bracket found, each polished to rounding; and the derivatives
/// of the extreme value with respect to the design, by the envelope theorem.

#include <algorithm>
#include <array>
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

namespace detail {

/// Zeros found near the samples at hand, in increasing order.
struct NearZeros {
    static constexpr std::size_t most = 12;
    std::array<double, most> at{};
    std::size_t count = 0, reported = 0;

    template <class Found>
    void add(double x, const Found& found) {
        if (count == most) report_until(at[most - 1], found), forget_before(x);
        if (count == most) return;
        const auto place = std::upper_bound(at.begin() + reported, at.begin() + count, x);
        std::copy_backward(place, at.begin() + count, at.begin() + count + 1);
        *place = x;
        ++count;
    }
    template <class Found>
    void report_until(double x, const Found& found) {
        for (; reported < count && at[reported] <= x; ++reported)
            found(at[reported]);
    }
    void forget_before(double x) {
        const auto kept = std::lower_bound(at.begin(), at.begin() + reported, x);
        const auto gone = static_cast<std::size_t>(kept - at.begin());
        std::copy(kept, at.begin() + count, at.begin());
        count -= gone;
        reported -= gone;
    }
};

}  // namespace detail

/// Reports to `found(x)` the zeros of `g` between neighbouring grid points, in increasing order: every change of sign,
/// and pairs of zeros between points where |g| dips without changing sign. Beside zeros that are known already, it is g
/// over its distances from them that dips. Points where g is not finite bracket nothing. Grid points are asked for in
/// their order, each once.
template <class Function, class Found>
void zeros_on_grid(const Function& g, std::span<const double> grid, const Found& found) {
    struct Sample {
        double x, g;
    };
    std::array<double, 5> values{};  // of the last points
    detail::NearZeros zeros;
    const auto value = [&](std::size_t i) -> double& { return values[i % values.size()]; };

    // More zeros than this within three steps of a point are those of rounding.
    constexpr std::size_t most_beside = 8;
    // Nearer than this part of the steps to a zero, g over the distance from it is rounding.
    constexpr double beside = 1e-6;
    std::size_t looked_at = 0;
    const auto look_for_dip = [&](std::size_t middle) {
        const double near = beside * (grid[middle + 1] - grid[middle - 1]);
        if (middle == looked_at || zeros.count > most_beside) return;
        const auto moved = [&](double x) {
            for (std::size_t k = 0; k < zeros.count; ++k)
                if (std::abs(x - zeros.at[k]) < near) return zeros.at[k] + (x < zeros.at[k] ? -near : near);
            return x;
        };
        const auto over_distances = [&](double x, double gx) {
            for (std::size_t k = 0; k < zeros.count; ++k)
                gx /= x - zeros.at[k];
            return gx;
        };
        const auto at_point = [&](std::size_t i) {
            const double x = moved(grid[i]);
            return Sample{x, over_distances(x, x == grid[i] ? value(i) : g(x))};
        };
        const auto one_sign = [](const Sample& a, const Sample& b) {
            return std::isfinite(a.g) && std::isfinite(b.g) && a.g != 0 && b.g != 0 && (a.g > 0) == (b.g > 0);
        };
        const Sample a = at_point(middle - 1), b = at_point(middle), c = at_point(middle + 1);
        if (!one_sign(a, b) || !one_sign(b, c) || std::abs(b.g) > std::abs(a.g) || std::abs(b.g) > std::abs(c.g))
            return;
        looked_at = middle;
        const auto smooth = [&](double x) {
            const double off = moved(x);
            return over_distances(off, g(off));
        };
        std::array<double, 2> pair;
        std::size_t count = 0;
        zeros_in_dip(smooth, a.x, b.x, c.x, a.g, b.g, c.g, [&](double x) {
            if (moved(x) == x) pair[count++] = x;
        });
        for (std::size_t k = 0; k < count; ++k)
            zeros.add(pair[k], found);
    };

    // Where g is zero at a point itself, its sign within the step beside it is asked for.
    const auto look_for_change = [&](std::size_t i) {
        const double step = beside * (grid[i + 1] - grid[i]);
        const auto within = [&](std::size_t point, double inwards) {
            return value(point) != 0 ? Sample{grid[point], value(point)}
                                     : Sample{grid[point] + inwards, g(grid[point] + inwards)};
        };
        const Sample left = within(i, step), right = within(i + 1, -step);
        if (std::isfinite(left.g) && std::isfinite(right.g) && left.g != 0 && right.g != 0 &&
            (left.g > 0) != (right.g > 0))
            zeros.add(zero_between<double>(g, left.x, right.x, left.g, right.g), found);
    };

    for (std::size_t i = 0; i < grid.size() + 2; ++i) {
        if (i < grid.size()) {
            value(i) = g(grid[i]);
            if (i > 0) look_for_change(i - 1);
            if (value(i) == 0) zeros.add(grid[i], found);
        }
        if (i < 4) continue;
        // Of both ends of a step, beside the same zeros: else a pair within it could make neither of them the least.
        look_for_dip(i - 3);
        if (i - 1 < grid.size()) look_for_dip(i - 2);
        zeros.report_until(grid[i - 3], found);
        zeros.forget_before(grid[i - 4 - (i > 4)]);
    }
    if (!grid.empty()) zeros.report_until(grid.back(), found);
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
