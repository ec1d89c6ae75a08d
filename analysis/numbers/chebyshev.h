#pragma once
/// \file
/// Smooth functions of an interval as sums of Chebyshev polynomials: sum_k c_k T_k(x), -1 <= x <= 1. Reference:
/// Trefethen, Approximation Theory and Approximation Practice, chapters 3 and 4 (coefficients from the values at the
/// zeros of T_n) and 19 (Clenshaw's recurrence).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace mechwright {

/// The value of a series at x; T may be a dual number.
template <class T>
T chebyshev_value(std::span<const double> series, const T& x) {
    T next(0.0);
    T after(0.0);
    for (std::size_t k = series.size(); k-- > 1;) {
        const T here = T(2.0) * x * next - after + T(series[k]);
        after = next;
        next = here;
    }
    return x * next - after + T(series.empty() ? 0.0 : series[0]);
}

/// The series of f to rounding, with as few terms as it takes; nothing if 512 do not.
template <class Function>
std::optional<std::vector<double>> chebyshev_series(const Function& f) {
    constexpr double last_digits = 1e-15;
    for (std::size_t n = 16; n <= 512; n *= 2) {
        const double step = std::numbers::pi / static_cast<double>(n);
        std::vector<double> values(n);
        double greatest = 0;
        for (std::size_t j = 0; j < n; ++j) {
            values[j] = f(std::cos((static_cast<double>(j) + 0.5) * step));
            greatest = std::max(greatest, std::abs(values[j]));
        }
        std::vector<double> series(n);
        for (std::size_t k = 0; k < n; ++k) {
            double sum = 0;
            for (std::size_t j = 0; j < n; ++j)
                sum += values[j] * std::cos(static_cast<double>(k) * (static_cast<double>(j) + 0.5) * step);
            series[k] = (k == 0 ? 1.0 : 2.0) * sum / static_cast<double>(n);
        }
        const auto negligible = [&](double c) { return std::abs(c) <= 4 * last_digits * greatest; };
        if (!std::all_of(series.end() - static_cast<std::ptrdiff_t>(n / 4), series.end(), negligible)) continue;
        while (series.size() > 1 && negligible(series.back()))
            series.pop_back();
        return series;
    }
    return std::nullopt;
}

}  // namespace mechwright
