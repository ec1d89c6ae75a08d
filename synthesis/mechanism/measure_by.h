#pragma once
/// \file
/// What measured.h declares: a formula with its derivatives in the memory that a measurement is written to. Included by
/// the files that make the quantities of a mechanism, each of its formulas is compiled once.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "synthesis/mechanism/measured.h"

namespace mechwright {

template <class Formula>
void measure_by(const Motion& motion, std::span<const double> arguments, const Measurement& out) {
    constexpr std::size_t n = Formula::reads;
    constexpr std::size_t pairs = n * (n + 1) / 2;
    static_assert(Formula::most <= Quantity::most_components);
    const auto evaluate = [&]<class T>(std::array<T, Formula::most>& at) {
        return Formula::template components<T>(motion, seeded<T, n>(arguments), at);
    };
    const auto set_gradient = [&](std::size_t k, const std::array<double, n>& partial) {
        std::copy(partial.begin(), partial.end(), out.gradient.subspan(k * n, n).begin());
    };
    if (!out.hessian.empty()) {
        std::array<SecondDual<double, n>, Formula::most> c;
        const std::size_t count = evaluate(c);
        for (std::size_t k = 0; k < count; ++k) {
            out.value[k] = c[k].value;
            if (!out.gradient.empty()) set_gradient(k, c[k].first);
            std::copy(c[k].second.begin(), c[k].second.end(), out.hessian.subspan(k * pairs, pairs).begin());
        }
    } else if (!out.gradient.empty()) {
        std::array<Dual<double, n>, Formula::most> c;
        const std::size_t count = evaluate(c);
        for (std::size_t k = 0; k < count; ++k) {
            out.value[k] = c[k].value;
            set_gradient(k, c[k].partial);
        }
    } else {
        std::array<double, Formula::most> c;
        const std::size_t count = evaluate(c);
        std::copy_n(c.begin(), count, out.value.begin());
    }
}

}  // namespace mechwright
