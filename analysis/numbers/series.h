#pragma once
/// \file
/// Taylor series in one variable, cut after the power K: a value with its first K derivatives, carried through the same
/// formulas as the value. Each operation solves the equation above it power by power (Griewank and Walther, Evaluating
/// Derivatives, table 13.2). T is any number type of these formulas, also one with partial derivatives of its own.
/// At a point where a derivative does not exist (sqrt and hypot at zero) the higher coefficients are zero, as in
/// dual.h.

#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/numbers/scalar.h"

namespace mechwright {

template <class T, std::size_t K>
struct Series {
    using Value = T;
    std::array<T, K + 1> c;  ///< c[k] is the k-th derivative over k!

    Series() = default;  ///< not initialised, as plain numbers are not
    // NOLINTNEXTLINE(google-explicit-constructor): constants mix freely
    constexpr Series(const T& constant) {
        c[0] = constant;
        for (std::size_t k = 1; k <= K; ++k)
            c[k] = T(0);
    }
    template <class Number>
    requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, T>)
        // NOLINTNEXTLINE(google-explicit-constructor): constants mix freely
        constexpr Series(Number constant)
        : Series(T(constant)) {}

    /// The independent variable at `at`, or one that grows by `rate` with it.
    static constexpr Series variable(const T& at, const T& rate = T(1)) {
        Series x(at);
        if constexpr (K > 0) x.c[1] = rate;
        return x;
    }

    /// The derivative of this order, K at most.
    constexpr T derivative(std::size_t order) const {
        double factorial = 1;
        for (std::size_t k = 2; k <= order; ++k)
            factorial *= static_cast<double>(k);
        return T(factorial) * c[order];
    }

    friend constexpr Series operator+(const Series& a, const Series& b) {
        return by_powers([&](std::size_t k) { return T(a.c[k] + b.c[k]); });
    }
    friend constexpr Series operator-(const Series& a, const Series& b) {
        return by_powers([&](std::size_t k) { return T(a.c[k] - b.c[k]); });
    }
    friend constexpr Series operator+(const Series& a) { return a; }
    friend constexpr Series operator-(const Series& a) {
        return by_powers([&](std::size_t k) { return T(-a.c[k]); });
    }
    // Cauchy's product.
    friend constexpr Series operator*(const Series& a, const Series& b) {
        if constexpr (K == 2) {
            // Written out it is part of what calls it, in the same order.
            Series r;
            r.c[0] = a.c[0] * b.c[0];
            r.c[1] = a.c[0] * b.c[1] + a.c[1] * b.c[0];
            r.c[2] = (a.c[0] * b.c[2] + a.c[1] * b.c[1]) + a.c[2] * b.c[0];
            return r;
        }
        return by_powers([&](std::size_t k) {
            T sum = a.c[0] * b.c[k];
            for (std::size_t j = 1; j <= k; ++j)
                sum += a.c[j] * b.c[k - j];
            return sum;
        });
    }
    friend constexpr Series operator*(const Series& a, const T& b) {
        return by_powers([&](std::size_t k) { return T(a.c[k] * b); });
    }
    friend constexpr Series operator*(const T& a, const Series& b) { return b * a; }
    // q b = a.
    friend constexpr Series operator/(const Series& a, const Series& b) {
        const T inverse = T(1) / b.c[0];
        Series q;
        q.c[0] = a.c[0] / b.c[0];
        for (std::size_t k = 1; k <= K; ++k) {
            T rest = a.c[k];
            for (std::size_t j = 0; j < k; ++j)
                rest -= q.c[j] * b.c[k - j];
            q.c[k] = rest * inverse;
        }
        return q;
    }
    friend constexpr Series operator/(const Series& a, const T& b) {
        return by_powers([&](std::size_t k) { return T(a.c[k] / b); });
    }
    constexpr Series& operator+=(const Series& b) { return *this = *this + b; }
    constexpr Series& operator-=(const Series& b) { return *this = *this - b; }
    constexpr Series& operator*=(const Series& b) { return *this = *this * b; }
    constexpr Series& operator/=(const Series& b) { return *this = *this / b; }

    friend constexpr bool operator<(const Series& a, const Series& b) { return a.c[0] < b.c[0]; }
    friend constexpr bool operator>(const Series& a, const Series& b) { return a.c[0] > b.c[0]; }
    friend constexpr bool operator<=(const Series& a, const Series& b) { return a.c[0] <= b.c[0]; }
    friend constexpr bool operator>=(const Series& a, const Series& b) { return a.c[0] >= b.c[0]; }
    friend constexpr bool operator==(const Series& a, const Series& b) { return a.c[0] == b.c[0]; }

    /// The series with these coefficients.
    template <class Coefficient>
    static constexpr Series by_powers(const Coefficient& coefficient) {
        Series r;
        for (std::size_t k = 0; k <= K; ++k)
            r.c[k] = coefficient(k);
        return r;
    }
};

template <class T, std::size_t K>
constexpr decltype(auto) value_of(const Series<T, K>& x) {
    return value_of(x.c[0]);
}

/// The derivative as a series; its last coefficient, which is not known, is 0.
template <class T, std::size_t K>
constexpr Series<T, K> slope_of(const Series<T, K>& a) {
    return Series<T, K>::by_powers(
        [&](std::size_t k) { return k < K ? T(T(static_cast<double>(k + 1)) * a.c[k + 1]) : T(0); });
}

namespace detail {

/// The series r with r r = square, whose value is known.
template <class T, std::size_t K>
Series<T, K> root_of(const Series<T, K>& square, const T& value) {
    Series<T, K> r(value);
    if (!(value > T(0))) return r;
    const T half = T(0.5) / value;
    for (std::size_t k = 1; k <= K; ++k) {
        T rest = square.c[k];
        for (std::size_t j = 1; j < k; ++j)
            rest -= r.c[j] * r.c[k - j];
        r.c[k] = rest * half;
    }
    return r;
}

}  // namespace detail

// s' = c a', c' = -s a'.
template <class T, std::size_t K>
SineAndCosine<Series<T, K>> sine_and_cosine(const Series<T, K>& a) {
    Series<T, K> sine, cosine;
    const SineAndCosine<T> value = sine_and_cosine(a.c[0]);
    sine.c[0] = value.sine;
    cosine.c[0] = value.cosine;
    for (std::size_t k = 1; k <= K; ++k) {
        T s(0), c(0);
        for (std::size_t j = 1; j <= k; ++j) {
            const T slope = T(static_cast<double>(j)) * a.c[j];
            s += slope * cosine.c[k - j];
            c -= slope * sine.c[k - j];
        }
        sine.c[k] = s / T(static_cast<double>(k));
        cosine.c[k] = c / T(static_cast<double>(k));
    }
    return {sine, cosine};
}

// r r = a.
template <class T, std::size_t K>
Series<T, K> sqrt(const Series<T, K>& a) {
    using std::sqrt;
    return detail::root_of(a, T(sqrt(a.c[0])));
}

/// r r = a a + b b, with c + e for r, where c is along the value (a, b) and d across it: e (2 c + e) = d d. So nothing
/// cancels, and little of the rounding of a and b is divided by a value that is small.
template <class T, std::size_t K>
Series<T, K> hypot(const Series<T, K>& a, const Series<T, K>& b) {
    const T value = hypotenuse(a.c[0], b.c[0]);
    if (!(value > T(0))) return Series<T, K>(value);
    const T x = a.c[0] / value, y = b.c[0] / value;
    const Series<T, K> along = x * a + y * b, across = x * b - y * a;
    const T half = T(0.5) / value;
    Series<T, K> r(value), more(T(0));
    for (std::size_t k = 1; k <= K; ++k) {
        T rest(0);
        for (std::size_t j = 1; j < k; ++j)
            rest += across.c[j] * across.c[k - j] - more.c[j] * (along.c[k - j] + r.c[k - j]);
        more.c[k] = rest * half;
        r.c[k] = along.c[k] + more.c[k];
    }
    return r;
}

template <class T, std::size_t K>
Series<T, K> sin(const Series<T, K>& a) {
    return sine_and_cosine(a).sine;
}

template <class T, std::size_t K>
Series<T, K> cos(const Series<T, K>& a) {
    return sine_and_cosine(a).cosine;
}

template <class T, std::size_t K>
Series<T, K> abs(const Series<T, K>& a) {
    return a.c[0] < T(0) ? -a : a;
}

// (x^2 + y^2) r' = x y' - y x'.
template <class T, std::size_t K>
Series<T, K> atan2(const Series<T, K>& y, const Series<T, K>& x) {
    using std::atan2;
    Series<T, K> r(T(atan2(y.c[0], x.c[0])));
    if (!(hypotenuse(x.c[0], y.c[0]) > T(0))) return r;
    const Series<T, K> slope = (x * slope_of(y) - y * slope_of(x)) / (x * x + y * y);
    for (std::size_t k = 1; k <= K; ++k)
        r.c[k] = slope.c[k - 1] / T(static_cast<double>(k));
    return r;
}

}  // namespace mechwright
