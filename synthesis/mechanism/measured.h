#pragma once
/// \file
/// Turns a formula, written once as a template, into the Measure functions of the registry.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "analysis/numbers/dual.h"
#include "analysis/numbers/extremes.h"
#include "analysis/numbers/second_dual.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

template <std::size_t N>
inline constexpr auto unit_vectors = [] {
    std::array<std::array<double, N>, N> unit{};
    for (std::size_t i = 0; i < N; ++i)
        unit[i][i] = 1;
    return unit;
}();

/// N arguments as numbers of type T; where T is a dual number, they are its variables.
template <class T, std::size_t N>
std::array<T, N> seeded(std::span<const double> arguments) {
    std::array<T, N> x;
    for (std::size_t i = 0; i < N; ++i) {
        x[i] = T(arguments[i]);
        if constexpr (requires { x[i].partial; })
            x[i].partial = unit_vectors<N>[i];
        else if constexpr (requires { x[i].first; })
            x[i].first = unit_vectors<N>[i];
    }
    return x;
}

/// The value of f(x, z) at a z where f is stationary in it, as a function of x: up to first derivatives that z is a
/// constant, to second ones the envelope theorem counts (extremes.h).
template <class T, std::size_t N, class Function>
T at_stationary(const std::array<T, N>& x, double z, const Function& f) {
    return f(x, T(z));
}

template <std::size_t M, std::size_t N, class Function>
SecondDual<double, M> at_stationary(const std::array<SecondDual<double, M>, N>& x, double z, const Function& f) {
    using Wide = SecondDual<double, M + 1>;
    std::array<Wide, N> wide;
    for (std::size_t i = 0; i < N; ++i) {
        wide[i] = Wide(x[i].value);
        std::copy(x[i].first.begin(), x[i].first.end(), wide[i].first.begin());
        std::copy(x[i].second.begin(), x[i].second.end(), wide[i].second.begin());
    }
    return stationary_value(f(wide, Wide::variable(z, M)));
}

/// Where a formula writes the components of its quantity: room for `Formula::most` of them.
template <class T>
using Components = std::span<T>;

/// Both ends of a limited motion, as far as a formula depends on them: constants, unless they are arguments of it.
template <class T>
struct Ends {
    T from;
    T to;
};

template <class T>
Ends<T> fixed_ends(const Motion& motion) {
    return {T(motion.from), T(motion.to)};
}

/// The measure of a formula with `static constexpr std::size_t reads`, `static constexpr std::size_t most` and
/// `template <class T> static std::size_t components(const Motion&, const std::array<T, reads>&, Components<T> out)`.
/// Defined in measure_by.h for those who make quantities; others only ask whether a quantity is measured by a formula,
/// and need not compile it again for that.
template <class Formula>
void measure_by(const Motion& motion, std::span<const double> arguments, const Measurement& out);

/// Whether a quantity is measured by this formula: how a closed form recognises what it solves, without its name.
template <class Formula>
bool is_measured_by(const Quantity& quantity) {
    return quantity.measure == &measure_by<Formula>;
}

}  // namespace mechwright
