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
constexpr std::array<std::size_t, N> first_indices() {
    std::array<std::size_t, N> all{};
    for (std::size_t i = 0; i < N; ++i)
        all[i] = i;
    return all;
}

/// The indices of the dimensions that a formula depends on: `uses`, in increasing order, where it says so, else all
/// that it reads.
template <class Formula>
constexpr auto used_by() {
    if constexpr (requires { Formula::uses; })
        return Formula::uses;
    else
        return first_indices<Formula::reads>();
}

template <std::size_t N>
inline constexpr auto unit_vectors = [] {
    std::array<std::array<double, N>, N> unit{};
    for (std::size_t i = 0; i < N; ++i)
        unit[i][i] = 1;
    return unit;
}();

/// The first N dimensions as numbers of type T; where T is a dual number, those whose indices `used` holds are its
/// variables, in that order.
template <class T, std::size_t N, auto used = first_indices<N>()>
std::array<T, N> seeded(std::span<const double> dimensions) {
    std::array<T, N> x;
    for (std::size_t i = 0; i < N; ++i)
        x[i] = T(dimensions[i]);
    if constexpr (requires { x[0].partial; })
        for (std::size_t k = 0; k < used.size(); ++k)
            x[used[k]].partial = unit_vectors<used.size()>[k];
    else if constexpr (requires { x[0].first; })
        for (std::size_t k = 0; k < used.size(); ++k)
            x[used[k]].first = unit_vectors<used.size()>[k];
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

/// The measure of a formula with `static constexpr std::size_t reads`, `static constexpr std::size_t most` and
/// `template <class T> static std::size_t components(const Motion&, const std::array<T, reads>&, Components<T> out)`;
/// where it depends on few of the dimensions it reads, `static constexpr std::array<std::size_t, ...> uses` names them.
/// Defined in measure_by.h for those who make quantities; others only ask whether a quantity is measured by a formula,
/// and need not compile it again for that.
template <class Formula>
void measure_by(const Motion& motion, std::span<const double> dimensions, const Measurement& out);

/// Whether a quantity is measured by this formula: how a closed form recognises what it solves, without its name.
template <class Formula>
bool is_measured_by(const Quantity& quantity) {
    return quantity.measure == &measure_by<Formula>;
}

}  // namespace mechwright
