#pragma once
/// \file
/// Turns a formula, written once as a template, into the Measure functions of the registry.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "analysis/extremes.h"
#include "analysis/numbers/dual.h"
#include "analysis/numbers/second_dual.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The first N dimensions as numbers of type T: independent variables where T is a dual number.
template <class T, std::size_t N>
std::array<T, N> seeded(std::span<const double> dimensions) {
    std::array<T, N> x;
    for (std::size_t i = 0; i < N; ++i) {
        if constexpr (requires { T::variable(0.0, i); })
            x[i] = T::variable(dimensions[i], i);
        else
            x[i] = T(dimensions[i]);
    }
    return x;
}

/// The value of f(x, z) at a z where f is stationary in it, as a function of x: up to first derivatives that z is a
/// constant, to second ones the envelope theorem counts (extremes.h).
template <class T, std::size_t N, class Function>
T at_stationary(const std::array<T, N>& x, double z, const Function& f) {
    return f(x, T(z));
}

template <std::size_t N, class Function>
SecondDual<double, N> at_stationary(const std::array<SecondDual<double, N>, N>& x, double z, const Function& f) {
    using Wide = SecondDual<double, N + 1>;
    std::array<Wide, N> wide;
    for (std::size_t i = 0; i < N; ++i) {
        wide[i] = Wide(x[i].value);
        std::copy(x[i].first.begin(), x[i].first.end(), wide[i].first.begin());
        std::copy(x[i].second.begin(), x[i].second.end(), wide[i].second.begin());
    }
    return stationary_value(f(wide, Wide::variable(z, N)));
}

/// Where a formula writes the components of its quantity: room for `Formula::most` of them.
template <class T>
using Components = std::span<T>;

/// The measure of a formula with `static constexpr std::size_t reads`, `static constexpr std::size_t most` and
/// `template <class T> static std::size_t components(const Motion&, const std::array<T, reads>&, Components<T> out)`.
template <class Formula>
void measure_by(const Motion& motion, std::span<const double> dimensions, const Measurement& out) {
    constexpr std::size_t n = Formula::reads;
    constexpr std::size_t pairs = n * (n + 1) / 2;
    static_assert(Formula::most <= Quantity::most_components);
    const auto evaluate = [&]<class T>(std::array<T, Formula::most>& at) {
        return Formula::template components<T>(motion, seeded<T, n>(dimensions), at);
    };
    if (!out.hessian.empty()) {
        std::array<SecondDual<double, n>, Formula::most> c;
        const std::size_t count = evaluate(c);
        for (std::size_t k = 0; k < count; ++k) {
            out.value[k] = c[k].value;
            if (!out.gradient.empty()) std::copy_n(c[k].first.begin(), n, out.gradient.begin() + k * n);
            std::copy_n(c[k].second.begin(), pairs, out.hessian.begin() + k * pairs);
        }
    } else if (!out.gradient.empty()) {
        std::array<Dual<double, n>, Formula::most> c;
        const std::size_t count = evaluate(c);
        for (std::size_t k = 0; k < count; ++k) {
            out.value[k] = c[k].value;
            std::copy_n(c[k].partial.begin(), n, out.gradient.begin() + k * n);
        }
    } else {
        std::array<double, Formula::most> c;
        const std::size_t count = evaluate(c);
        std::copy_n(c.begin(), count, out.value.begin());
    }
}

/// Whether a quantity is measured by this formula: how a closed form recognises what it solves, without its name.
template <class Formula>
bool is_measured_by(const Quantity& quantity) {
    return quantity.measure == &measure_by<Formula>;
}

}  // namespace mechwright
