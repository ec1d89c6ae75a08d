#pragma once
/// \file
/// A periodic cubic spline through tabulated lifts: twice continuously differentiable round the whole turn.

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/cam/law.h"

namespace mechwright::cam {

/// Knots at increasing parts of the turn, 0 <= u < 1, and the cubic between each and the next: the last one ends where
/// the first begins, a turn later.
template <class R>
struct PeriodicSpline {
    std::vector<R> knot;
    std::vector<R> value;
    std::vector<R> curvature;  ///< second derivative with respect to the part of the turn, at the knots

    std::size_t pieces() const { return knot.size(); }
    R begin(std::size_t piece) const { return piece == knot.size() ? knot.front() + R(1) : knot[piece]; }
};

namespace detail {

/// The solution of a cyclic tridiagonal system with rows (below, diagonal, above), diagonally dominant: Gaussian
/// elimination that carries the last column along.
template <class R>
std::vector<R> solve_cyclic(const std::vector<R>& below, std::vector<R> diagonal, const std::vector<R>& above,
                            std::vector<R> right) {
    const std::size_t n = diagonal.size(), last = n - 1;
    // Columns: x_i depends on x_{i+1} (above) and on x_last (corner).
    std::vector<R> corner(n, R(0));
    corner[0] = below[0];
    R last_row = above[last];  // the last row's coefficient of x_i, while elimination goes on
    for (std::size_t i = 0; i + 1 < last; ++i) {
        const R factor = below[i + 1] / diagonal[i];
        diagonal[i + 1] -= factor * above[i];
        corner[i + 1] = -factor * corner[i];
        right[i + 1] -= factor * right[i];
        const R of_last = last_row / diagonal[i];
        diagonal[last] -= of_last * corner[i];
        right[last] -= of_last * right[i];
        last_row = -of_last * above[i];
    }
    // The row before the last: its `above` and its `corner` belong to the same unknown.
    const std::size_t before = last - 1;
    const R beside = above[before] + corner[before];
    const R factor = (below[last] + last_row) / diagonal[before];
    std::vector<R> x(n);
    x[last] = (right[last] - factor * right[before]) / (diagonal[last] - factor * beside);
    x[before] = (right[before] - beside * x[last]) / diagonal[before];
    for (std::size_t i = before; i-- > 0;)
        x[i] = (right[i] - above[i] * x[i + 1] - corner[i] * x[last]) / diagonal[i];
    return x;
}

}  // namespace detail

/// The spline through the values at the knots. Precondition: three knots or more, increasing, within less than 1.
template <class R>
PeriodicSpline<R> periodic_spline(std::span<const R> knot, std::span<const R> value) {
    const std::size_t n = knot.size();
    const auto next = [n](std::size_t i) { return i + 1 == n ? 0 : i + 1; };
    std::vector<R> step(n), slope(n);
    for (std::size_t i = 0; i < n; ++i) {
        step[i] = i + 1 == n ? knot[0] + R(1) - knot[i] : knot[i + 1] - knot[i];
        slope[i] = (value[next(i)] - value[i]) / step[i];
    }
    std::vector<R> below(n), diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = i == 0 ? n - 1 : i - 1;
        below[i] = step[before];
        diagonal[i] = R(2) * (step[before] + step[i]);
        right[i] = R(6) * (slope[i] - slope[before]);
    }
    return {
        {knot.begin(), knot.end()}, {value.begin(), value.end()}, detail::solve_cyclic(below, diagonal, step, right)};
}

/// Its value and derivatives with respect to the part of the turn at u, by the cubic of the given piece.
template <class T>
Lift<T> lift_at(const PeriodicSpline<Constant<T>>& spline, std::size_t piece, const T& u) {
    using R = Constant<T>;
    const std::size_t end = piece + 1 == spline.pieces() ? 0 : piece + 1;
    const R step = spline.begin(piece + 1) - spline.begin(piece);
    const R m0 = spline.curvature[piece], m1 = spline.curvature[end];
    const R jerk = (m1 - m0) / step;
    const R slope = (spline.value[end] - spline.value[piece]) / step - step * (R(2) * m0 + m1) / R(6);
    const T t = u - T(spline.begin(piece));
    return {T(spline.value[piece]) + (T(slope) + (T(m0 / R(2)) + T(jerk / R(6)) * t) * t) * t,
            T(slope) + (T(m0) + T(jerk / R(2)) * t) * t, T(m0) + T(jerk) * t, T(jerk)};
}

}  // namespace mechwright::cam
