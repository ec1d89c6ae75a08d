#pragma once
/// \file
/// Taylor series in the crank angle, cut after the third power: position, velocity, acceleration and jerk of whatever
/// is computed with them follow without a formula for any of them. For verification alone.

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace mechwright::quick_return::again {

template <class T>
struct Jet {
    std::array<T, 4> c{};  ///< coefficients: c[k] is the k-th derivative over k!

    Jet() = default;
    Jet(const T& constant) : c{constant, T(0), T(0), T(0)} {}  // NOLINT(google-explicit-constructor)
    template <class Number>
    requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, T>) Jet(Number constant)
        : Jet(T(constant)) {}  // NOLINT(google-explicit-constructor)

    /// The crank angle itself, at a place.
    static Jet crank_angle(const T& at) {
        Jet x(at);
        x.c[1] = T(1);
        return x;
    }

    friend Jet operator+(const Jet& a, const Jet& b) {
        Jet r;
        for (std::size_t k = 0; k < 4; ++k)
            r.c[k] = a.c[k] + b.c[k];
        return r;
    }
    friend Jet operator-(const Jet& a, const Jet& b) {
        Jet r;
        for (std::size_t k = 0; k < 4; ++k)
            r.c[k] = a.c[k] - b.c[k];
        return r;
    }
    friend Jet operator-(const Jet& a) { return Jet() - a; }
    // Cauchy's product.
    friend Jet operator*(const Jet& a, const Jet& b) {
        Jet r;
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t j = 0; j <= k; ++j)
                r.c[k] += a.c[j] * b.c[k - j];
        return r;
    }
    // q b = a, solved power by power.
    friend Jet operator/(const Jet& a, const Jet& b) {
        Jet q;
        for (std::size_t k = 0; k < 4; ++k) {
            T rest = a.c[k];
            for (std::size_t j = 0; j < k; ++j)
                rest -= q.c[j] * b.c[k - j];
            q.c[k] = rest / b.c[0];
        }
        return q;
    }
    friend bool operator<(const Jet& a, const Jet& b) { return a.c[0] < b.c[0]; }
    friend bool operator>(const Jet& a, const Jet& b) { return a.c[0] > b.c[0]; }
    friend bool operator>=(const Jet& a, const Jet& b) { return a.c[0] >= b.c[0]; }
};

// r r = a, solved power by power.
template <class T>
Jet<T> sqrt(const Jet<T>& a) {
    using std::sqrt;
    Jet<T> r;
    r.c[0] = sqrt(a.c[0]);
    for (std::size_t k = 1; k < 4; ++k) {
        T rest = a.c[k];
        for (std::size_t j = 1; j < k; ++j)
            rest -= r.c[j] * r.c[k - j];
        r.c[k] = rest / (2 * r.c[0]);
    }
    return r;
}

/// Sine and cosine together: s' = c a', c' = -s a', solved power by power.
template <class T>
struct SineCosine {
    Jet<T> sine;
    Jet<T> cosine;
};

template <class T>
SineCosine<T> sine_cosine(const Jet<T>& a) {
    using std::cos, std::sin;
    SineCosine<T> r;
    r.sine.c[0] = sin(a.c[0]);
    r.cosine.c[0] = cos(a.c[0]);
    for (std::size_t k = 1; k < 4; ++k) {
        T s(0), c(0);
        for (std::size_t j = 1; j <= k; ++j) {
            const T slope = static_cast<int>(j) * a.c[j];
            s += slope * r.cosine.c[k - j];
            c -= slope * r.sine.c[k - j];
        }
        r.sine.c[k] = s / static_cast<int>(k);
        r.cosine.c[k] = c / static_cast<int>(k);
    }
    return r;
}

template <class T>
Jet<T> sin(const Jet<T>& a) {
    return sine_cosine(a).sine;
}

template <class T>
Jet<T> cos(const Jet<T>& a) {
    return sine_cosine(a).cosine;
}

}  // namespace mechwright::quick_return::again
