#pragma once
/// \file
/// A rise or return as a spline of fifth degree with evenly spaced knots: velocity and acceleration are zero at both
/// ends, and its inner coefficients are free. Four times continuously differentiable. De Boor, A Practical Guide to
/// Splines.

#include <array>
#include <cstddef>
#include <span>

#include "analysis/cam/law.h"

namespace mechwright::cam {

inline constexpr std::size_t spline_degree = 5;

namespace detail {

/// Knot number i of a spline with `inner` inner knots: the first and the last stand six times each.
template <class R>
R spline_knot(std::size_t i, std::size_t inner) {
    if (i <= spline_degree) return R(0);
    if (i > spline_degree + inner) return R(1);
    return R(static_cast<double>(i - spline_degree)) / R(static_cast<double>(inner + 1));
}

/// The spline of this degree whose coefficients around piece number `piece` are given (degree + 1 of them), at u.
template <class T>
T de_boor(std::array<T, spline_degree + 1> c, std::size_t degree, std::size_t piece, std::size_t inner, const T& u) {
    using R = Constant<T>;
    for (std::size_t level = 1; level <= degree; ++level)
        for (std::size_t j = degree; j >= level; --j) {
            const R left = spline_knot<R>(piece + j + spline_degree - degree, inner);
            const R right = spline_knot<R>(piece + j + 1 + spline_degree - level, inner);
            const T part = (u - T(left)) / T(right - left);
            c[j] = (T(R(1)) - part) * c[j - 1] + part * c[j];
        }
    return c[degree];
}

}  // namespace detail

/// How many pieces a spline with so many free coefficients has.
inline std::size_t spline_pieces(std::size_t free) { return free + 1; }

/// The spline that begins at `first`, ends at `last` and has the free coefficients between; derivatives are with
/// respect to u. Precondition: u in the piece, or near it.
template <class T>
Lift<T> spline_lift(const T& first, const T& last, std::span<const T> free, std::size_t piece, const T& u) {
    using R = Constant<T>;
    const std::size_t inner = free.size();
    const auto coefficient = [&](std::size_t i) { return i < 3 ? first : i < 3 + inner ? free[i - 3] : last; };
    std::array<T, spline_degree + 1> c;
    for (std::size_t i = 0; i <= spline_degree; ++i)
        c[i] = coefficient(piece + i);
    std::array<T, 4> derivative;
    for (std::size_t order = 0; order < derivative.size(); ++order) {
        const std::size_t degree = spline_degree - order;
        derivative[order] = detail::de_boor(c, degree, piece, inner, u);
        // The coefficients of the next derivative.
        for (std::size_t i = 0; i < degree; ++i) {
            const R width = detail::spline_knot<R>(piece + i + spline_degree + 1, inner) -
                            detail::spline_knot<R>(piece + i + 1 + order, inner);
            c[i] = T(R(static_cast<double>(degree)) / width) * (c[i + 1] - c[i]);
        }
    }
    return {derivative[0], derivative[1], derivative[2], derivative[3]};
}

}  // namespace mechwright::cam
