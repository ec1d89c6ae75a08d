#pragma once
/// \file
/// First-order dual numbers: a value with N partial derivatives, carried through the same formulas as the value.
/// With x = a + sum_i a_i e_i and e_i e_j = 0, f(x) = f(a) + f'(a) sum_i a_i e_i; each rule stands above its function.
/// At a point where a derivative does not exist (sqrt and hypot at zero, abs at zero) the partials are zero instead of
/// infinite or NaN: kinematic functions report such points by a margin of zero, which the caller looks at.

#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/numbers/scalar.h"

namespace mechwright {

template <class T, std::size_t N>
struct Dual {
    using Value = T;
    T value;
    std::array<T, N> partial;

    Dual() = default;  ///< not initialised, as plain numbers are not
    // NOLINTNEXTLINE(google-explicit-constructor): constants mix freely
    constexpr Dual(const T& constant) : value(constant), partial{} {}

    // Member by member: a copy of the whole in wide registers would wait for the narrow store of the value.
    constexpr Dual(const Dual& b) : value(b.value), partial(b.partial) {}
    constexpr Dual& operator=(const Dual& b) {
        value = b.value;
        partial = b.partial;
        return *this;
    }

    /// The independent variable number `index`, at `at`.
    static constexpr Dual variable(const T& at, std::size_t index) {
        Dual x(at);
        x.partial[index] = T(1);
        return x;
    }

    constexpr Dual& operator+=(const Dual& b) { return *this = *this + b; }
    constexpr Dual& operator-=(const Dual& b) { return *this = *this - b; }
    constexpr Dual& operator*=(const Dual& b) { return *this = *this * b; }
    constexpr Dual& operator/=(const Dual& b) { return *this = *this / b; }

    // Hidden friends, so that a plain number on either side converts.

    // (a + b)' = a' + b'
    friend constexpr Dual operator+(const Dual& a, const Dual& b) {
        return linear(a.value + b.value, a, b, T(1), T(1));
    }
    // (a - b)' = a' - b'
    friend constexpr Dual operator-(const Dual& a, const Dual& b) {
        Dual r(a.value - b.value);
        for (std::size_t i = 0; i < N; ++i)
            r.partial[i] = a.partial[i] - b.partial[i];
        return r;
    }
    friend constexpr Dual operator+(const Dual& a) { return a; }
    friend constexpr Dual operator-(const Dual& a) { return chain(a, -a.value, T(-1)); }
    // (a b)' = b a' + a b'
    friend constexpr Dual operator*(const Dual& a, const Dual& b) {
        return linear(a.value * b.value, a, b, b.value, a.value);
    }
    friend constexpr Dual operator*(const Dual& a, const T& b) { return chain(a, a.value * b, b); }
    friend constexpr Dual operator*(const T& a, const Dual& b) { return chain(b, a * b.value, a); }
    friend constexpr Dual operator+(const Dual& a, const T& b) {
        Dual r = a;
        r.value = a.value + b;
        return r;
    }
    friend constexpr Dual operator+(const T& a, const Dual& b) { return b + a; }
    friend constexpr Dual operator-(const Dual& a, const T& b) {
        Dual r = a;
        r.value = a.value - b;
        return r;
    }
    // (a / b)' = (a' - (a / b) b') / b
    friend constexpr Dual operator/(const Dual& a, const Dual& b) {
        const T quotient = a.value / b.value;
        const T inverse = T(1) / b.value;
        return linear(quotient, a, b, inverse, -quotient * inverse);
    }
    friend constexpr Dual operator/(const Dual& a, const T& b) { return chain(a, a.value / b, T(1) / b); }

    friend constexpr bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
    friend constexpr bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
    friend constexpr bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
    friend constexpr bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
    friend constexpr bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }

    /// A function of one argument: its value and its derivative there.
    static constexpr Dual chain(const Dual& a, const T& f, const T& df) {
        Dual r(f);
        for (std::size_t i = 0; i < N; ++i)
            r.partial[i] = df * a.partial[i];
        return r;
    }

    /// A function of two arguments: its value and its two partial derivatives there.
    static constexpr Dual linear(const T& f, const Dual& a, const Dual& b, const T& fa, const T& fb) {
        Dual r(f);
        for (std::size_t i = 0; i < N; ++i)
            r.partial[i] = fa * a.partial[i] + fb * b.partial[i];
        return r;
    }
};

template <class T, std::size_t N>
constexpr const T& value_of(const Dual<T, N>& x) {
    return x.value;
}

// sqrt(a)' = a' / (2 sqrt(a))
template <class T, std::size_t N>
Dual<T, N> sqrt(const Dual<T, N>& a) {
    using std::sqrt;
    const T root = sqrt(a.value);
    return Dual<T, N>::chain(a, root, root > T(0) ? T(0.5) / root : T(0));
}

// sin(a)' = cos(a) a'
template <class T, std::size_t N>
Dual<T, N> sin(const Dual<T, N>& a) {
    const auto [sine, cosine] = sine_and_cosine(a.value);
    return Dual<T, N>::chain(a, sine, cosine);
}

// cos(a)' = -sin(a) a'
template <class T, std::size_t N>
Dual<T, N> cos(const Dual<T, N>& a) {
    const auto [sine, cosine] = sine_and_cosine(a.value);
    return Dual<T, N>::chain(a, cosine, -sine);
}

template <class T, std::size_t N>
SineAndCosine<Dual<T, N>> sine_and_cosine(const Dual<T, N>& a) {
    const auto [sine, cosine] = sine_and_cosine(a.value);
    return {Dual<T, N>::chain(a, sine, cosine), Dual<T, N>::chain(a, cosine, -sine)};
}

// |a|' = sign(a) a'
template <class T, std::size_t N>
Dual<T, N> abs(const Dual<T, N>& a) {
    return a.value < T(0) ? -a : a;
}

// hypot(a, b)' = (a a' + b b') / hypot(a, b)
template <class T, std::size_t N>
Dual<T, N> hypot(const Dual<T, N>& a, const Dual<T, N>& b) {
    const T h = hypotenuse(a.value, b.value);
    if (!(h > T(0))) return Dual<T, N>(h);
    return Dual<T, N>::linear(h, a, b, a.value / h, b.value / h);
}

// atan2(y, x)' = (x y' - y x') / (x^2 + y^2)
template <class T, std::size_t N>
Dual<T, N> atan2(const Dual<T, N>& y, const Dual<T, N>& x) {
    using std::atan2;
    const T h = hypotenuse(x.value, y.value);
    const T angle = atan2(y.value, x.value);
    if (!(h > T(0))) return Dual<T, N>(angle);
    const T per_h = T(1) / h;
    return Dual<T, N>::linear(angle, y, x, (x.value * per_h) * per_h, -(y.value * per_h) * per_h);
}

/// (a + b) - (c + d), the value compensated (scalar.h).
template <class T, std::size_t N>
Dual<T, N> sum_difference(const Dual<T, N>& a, const Dual<T, N>& b, const Dual<T, N>& c, const Dual<T, N>& d) {
    Dual<T, N> r(sum_difference(a.value, b.value, c.value, d.value));
    for (std::size_t i = 0; i < N; ++i)
        r.partial[i] = (a.partial[i] + b.partial[i]) - (c.partial[i] + d.partial[i]);
    return r;
}

}  // namespace mechwright
