#pragma once
/// \file
/// A polynomial with given derivatives at both ends of a segment, and further terms that leave those ends as they are:
/// Hermite interpolation in Newton's form.

#include <algorithm>
#include <array>
#include <cstddef>

#include "analysis/cam/law.h"

namespace mechwright::cam {

/// Derivatives with respect to u at both ends, from the first one on: {0, 0} is an end at rest without acceleration.
/// Term k of `shape` is shape[k] 4^m (u (1 - u))^... times (2 u - 1)^k, of the size of shape[k] in the middle.
template <class T>
struct BoundaryPolynomial {
    static constexpr std::size_t most_conditions = 4;
    static constexpr std::size_t most_shape = 6;
    std::array<T, most_conditions> start{};
    std::array<T, most_conditions> end{};
    std::size_t start_count = 2;
    std::size_t end_count = 2;
    std::array<T, most_shape> shape{};
    std::size_t shape_count = 0;
};

/// The polynomial that goes from 0 to `rise` while u goes from 0 to 1, and its derivatives with respect to u.
template <class T>
Lift<T> lift_at(const BoundaryPolynomial<T>& p, const T& rise, const T& u) {
    using R = Constant<T>;
    constexpr std::size_t most = 2 * (BoundaryPolynomial<T>::most_conditions + 1) + BoundaryPolynomial<T>::most_shape;
    const std::size_t at_start = p.start_count + 1, at_end = p.end_count + 1, n = at_start + at_end;
    const auto node = [&](std::size_t i) { return i < at_start ? R(0) : i < n ? R(1) : R(1) / R(2); };
    // Divided differences; those of one repeated node are derivatives over factorials.
    const auto derivative = [&](std::size_t i, std::size_t order) {
        const bool first = i < at_start;
        if (order == 0) return first ? T(R(0)) : rise;
        R factorial(1);
        for (std::size_t k = 2; k <= order; ++k)
            factorial *= R(static_cast<double>(k));
        return (first ? p.start[order - 1] : p.end[order - 1]) / T(factorial);
    };
    std::array<T, most> table{}, coefficient{};
    for (std::size_t i = 0; i < n; ++i)
        table[i] = derivative(i, 0);
    coefficient[0] = table[0];
    for (std::size_t order = 1; order < n; ++order) {
        for (std::size_t i = 0; i + order < n; ++i)
            table[i] = node(i) == node(i + order) ? derivative(i, order) : table[i + 1] - table[i];
        coefficient[order] = table[0];
    }
    R scale(1);
    for (std::size_t k = 0; k < std::max(at_start, at_end); ++k)
        scale *= R(4);
    if (at_end % 2 == 1) scale = -scale;  // (u - 1) to an odd power
    for (std::size_t k = 0; k < p.shape_count; ++k, scale *= R(2))
        coefficient[n + k] = p.shape[k] * T(scale);
    Lift<T> f;
    for (std::size_t i = n + p.shape_count; i-- > 0;) {
        const T x = u - T(node(i));
        f.j = f.j * x + T(R(3)) * f.a;
        f.a = f.a * x + T(R(2)) * f.v;
        f.v = f.v * x + f.s;
        f.s = f.s * x + coefficient[i];
    }
    return f;
}

}  // namespace mechwright::cam
