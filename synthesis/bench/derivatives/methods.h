#pragma once
/// \file
/// Ways to a gradient that know nothing of a measure but its formula; each gives the value too.

#include <algorithm>
#include <limits>

#include "analysis/numbers/dual.h"
#include "synthesis/bench/derivatives/measures.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright::bench {

/// n + 1 values. Steps are `part` of each dimension.
template <class Measure>
ValueAndGradient<Measure::size> by_forward_differences(const std::array<double, Measure::size>& x, std::size_t place,
                                                       double part) {
    ValueAndGradient<Measure::size> out{Measure::value(x, place), {}};
    auto moved = x;
    for (std::size_t i = 0; i < Measure::size; ++i) {
        moved[i] = x[i] + part * x[i];
        out.gradient[i] = (Measure::value(moved, place) - out.value) / (moved[i] - x[i]);
        moved[i] = x[i];
    }
    return out;
}

/// Central difference in dimension i of a measure in the number type T: two values.
template <class Measure, class T>
T central_difference(const std::array<T, Measure::size>& x, std::size_t place, std::size_t i, const T& step) {
    auto right = x, left = x;
    right[i] = x[i] + step;
    left[i] = x[i] - step;
    return (Measure::value(right, place) - Measure::value(left, place)) / (right[i] - left[i]);
}

/// 2 n + 1 values.
template <class Measure>
ValueAndGradient<Measure::size> by_central_differences(const std::array<double, Measure::size>& x, std::size_t place,
                                                       double part) {
    ValueAndGradient<Measure::size> out{Measure::value(x, place), {}};
    for (std::size_t i = 0; i < Measure::size; ++i)
        out.gradient[i] = central_difference<Measure>(x, place, i, part * x[i]);
    return out;
}

/// Central differences with steps from a hundredth of each dimension on, halved up to ten times and extrapolated to
/// step 0; of the whole table the entry that differs least from its neighbours. (C. J. F. Ridders, "Accurate
/// computation of F'(x) and F'(x) F''(x)", Advances in Engineering Software 4, 1982.)
template <class Measure>
ValueAndGradient<Measure::size> by_extrapolation(const std::array<double, Measure::size>& x, std::size_t place) {
    constexpr std::size_t halvings = 10;
    ValueAndGradient<Measure::size> out{Measure::value(x, place), {}};
    for (std::size_t i = 0; i < Measure::size; ++i) {
        double step = 0.01 * x[i];
        std::array<double, halvings> above{}, row{};
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < halvings; ++k, step *= 0.5) {
            row[0] = central_difference<Measure>(x, place, i, step);
            if (k == 0) out.gradient[i] = row[0];
            double power = 4;
            for (std::size_t j = 1; j <= k; ++j, power *= 4) {
                row[j] = (power * row[j - 1] - above[j - 1]) / (power - 1);
                const double differs = std::max(std::abs(row[j] - row[j - 1]), std::abs(row[j] - above[j - 1]));
                if (!(differs < least)) continue;
                least = differs;
                out.gradient[i] = row[j];
            }
            if (k > 0 && std::abs(row[k] - above[k - 1]) > 2 * least) break;
            above = row;
        }
    }
    return out;
}

template <class Measure>
ValueAndGradient<Measure::size> by_dual_numbers(const std::array<double, Measure::size>& x, std::size_t place) {
    using Number = Dual<double, Measure::size>;
    std::array<Number, Measure::size> seeded;
    for (std::size_t i = 0; i < Measure::size; ++i)
        seeded[i] = Number::variable(x[i], i);
    const Number f = Measure::value(seeded, place);
    return {f.value, f.partial};
}

template <std::size_t n>
using ExactGradient = std::array<Digits50, n>;

/// To about thirty digits, by differences in fifty: no rule of differentiation stands behind it.
template <class Measure>
ExactGradient<Measure::size> exact_gradient(const std::array<Digits50, Measure::size>& x, std::size_t place) {
    ExactGradient<Measure::size> gradient;
    for (std::size_t i = 0; i < Measure::size; ++i)
        gradient[i] = central_difference<Measure>(x, place, i, Digits50(x[i] * 1e-17));
    return gradient;
}

/// The length of the difference over the length of the exact gradient.
template <class Number, std::size_t n>
double gradient_error(const std::array<Number, n>& gradient, const ExactGradient<n>& exact) {
    Digits50 error = 0, size = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Digits50 difference = Digits50(gradient[i]) - exact[i];
        error += difference * difference;
        size += exact[i] * exact[i];
    }
    return static_cast<double>(Digits50(sqrt(Digits50(error / size))));
}

/// What the rounding of a single dimension to double may change: at most, relative.
template <class Measure>
double rounding_of_dimensions(const std::array<Digits50, Measure::size>& x, std::size_t place,
                              const ExactGradient<Measure::size>& exact) {
    double greatest = 0;
    for (std::size_t i = 0; i < Measure::size; ++i) {
        auto moved = x;
        moved[i] *= 1 + std::ldexp(1.0, -52);
        greatest = std::max(greatest, 0.5 * gradient_error(exact_gradient<Measure>(moved, place), exact));
    }
    return greatest;
}

}  // namespace mechwright::bench
