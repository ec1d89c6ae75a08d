#pragma once
/// \file
/// The zeros of a trigonometric polynomial, all of them: a polynomial in w = e^(i angle) by its values at equally
/// spaced angles (discrete Fourier transform), its roots by Aberth's method, of these the ones at the unit circle (O.
/// Aberth, Iteration methods for finding all zeros of a polynomial simultaneously, Math. Comp. 27 (1973), 339-344).

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

namespace mechwright::linkage {

namespace detail {

using Complex = std::complex<double>;

/// The roots of the polynomial with these coefficients, the constant first; the last is not 0.
inline std::vector<Complex> polynomial_roots(const std::vector<Complex>& c) {
    constexpr int most_sweeps = 200;
    const std::size_t n = c.size() - 1;
    std::vector<Complex> roots(n);
    for (std::size_t i = 0; i < n; ++i)
        roots[i] = std::polar(1.0 + 0.03 * static_cast<double>(i % 3),
                              2 * std::numbers::pi * (static_cast<double>(i) + 0.35) / static_cast<double>(n));
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double moved = 0;
        for (std::size_t i = 0; i < n; ++i) {
            Complex value = c[n], slope = 0;
            for (std::size_t k = n; k-- > 0;) {
                slope = slope * roots[i] + value;
                value = value * roots[i] + c[k];
            }
            if (value == 0.0) continue;
            const Complex newton = value / slope;
            Complex others = 0;
            for (std::size_t k = 0; k < n; ++k)
                if (k != i) others += 1.0 / (roots[i] - roots[k]);
            const Complex step = newton / (1.0 - newton * others);
            if (!std::isfinite(step.real()) || !std::isfinite(step.imag())) continue;
            roots[i] -= step;
            moved = std::max(moved, std::abs(step) / (1 + std::abs(roots[i])));
        }
        if (moved < 1e-15) break;
    }
    return roots;
}

}  // namespace detail

/// Angles near all zeros of f, a trigonometric polynomial of this degree at most. Some may be near no zero: where f
/// nearly touches 0.
template <class Function>
std::vector<double> near_zeros(const Function& f, std::size_t degree) {
    constexpr double nothing = 1e-13, at_circle = 1e-2;
    const std::size_t count = 2 * degree + 1;
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k)
        values.push_back(f(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count)));
    std::vector<detail::Complex> c;
    double greatest = 0;
    for (std::size_t j = 0; j < count; ++j) {
        detail::Complex sum = 0;
        for (std::size_t k = 0; k < count; ++k)
            sum += std::polar(values[k], -2 * std::numbers::pi * static_cast<double>(k) *
                                             (static_cast<double>(j) - static_cast<double>(degree)) /
                                             static_cast<double>(count));
        c.push_back(sum / static_cast<double>(count));
        greatest = std::max(greatest, std::abs(c.back()));
    }
    while (c.size() > 1 && std::abs(c.back()) <= nothing * greatest && std::abs(c.front()) <= nothing * greatest) {
        c.pop_back();
        c.erase(c.begin());
    }
    std::vector<double> angles;
    if (c.size() < 2) return angles;
    for (const detail::Complex& root : detail::polynomial_roots(c))
        if (std::abs(std::abs(root) - 1) < at_circle) angles.push_back(std::arg(root));
    return angles;
}

}  // namespace mechwright::linkage
