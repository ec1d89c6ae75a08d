#pragma once
/// \file
/// Second-order dual numbers: a value with N first and N (N + 1) / 2 second partial derivatives.
/// For f(a): f_i = f' a_i, f_ij = f' a_ij + f'' a_i a_j; for f(a, b) the same with all mixed terms. Each function below
/// states only its derivatives. Points where a derivative does not exist are treated as in dual.h.

#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/numbers/scalar.h"

namespace mechwright {

namespace detail {

// Loops over the derivatives of wide numbers: compiled once for all widths, and called.

/// r = ka a + kb b, element by element.
template <class T>
[[gnu::noinline]] void wide_sum(std::size_t count, T* __restrict r, const T* a, const T ka, const T* b, const T kb) {
    for (std::size_t k = 0; k < count; ++k)
        r[k] = ka * a[k] + kb * b[k];
}

/// Adds a_i b_j + a_j b_i to r_ij of a lower triangle.
template <class T>
[[gnu::noinline]] void add_wide_products(std::size_t n, T* __restrict r, const T* a, const T* b) {
    for (std::size_t i = 0; i < n; r += ++i)
        for (std::size_t j = 0; j <= i; ++j)
            r[j] += a[i] * b[j] + a[j] * b[i];
}

/// r_ij = df a_ij + ddf a_i a_j of lower triangles; the first derivatives are `first`.
template <class T>
[[gnu::noinline]] void wide_chain(std::size_t n, T* __restrict r, const T* second, const T* first, const T df,
                                  const T ddf) {
    for (std::size_t i = 0; i < n; ++i, r += i, second += i)
        for (std::size_t j = 0; j <= i; ++j)
            r[j] = df * second[j] + ddf * first[i] * first[j];
}

/// Adds faa a_i a_j + fbb b_i b_j + fab (a_i b_j + a_j b_i) to r_ij of a lower triangle.
template <class T>
[[gnu::noinline]] void add_wide_chain(std::size_t n, T* __restrict r, const T* a, const T* b, const T faa, const T fab,
                                      const T fbb) {
    for (std::size_t i = 0; i < n; r += ++i)
        for (std::size_t j = 0; j <= i; ++j)
            r[j] += faa * a[i] * a[j] + fbb * b[i] * b[j] + fab * (a[i] * b[j] + a[j] * b[i]);
}

}  // namespace detail

template <class T, std::size_t N>
struct SecondDual {
    static constexpr std::size_t pairs = N * (N + 1) / 2;
    /// Of so many derivatives loops are called: a call takes no time beside them.
    static constexpr bool wide = N > 16;

    using Value = T;
    T value;
    std::array<T, N> first;
    std::array<T, pairs> second;  ///< lower triangle by rows: (i, j), j <= i, stands at i (i + 1) / 2 + j

    SecondDual() = default;  ///< not initialised, as plain numbers are not
    // NOLINTNEXTLINE(google-explicit-constructor)
    constexpr SecondDual(const T& constant) : value(constant), first{}, second{} {}

    /// The independent variable number `index`, at `at`.
    static constexpr SecondDual variable(const T& at, std::size_t index) {
        SecondDual x(at);
        x.first[index] = T(1);
        return x;
    }

    /// The second derivative with respect to variables i and j, in either order.
    constexpr const T& mixed(std::size_t i, std::size_t j) const {
        return i >= j ? second[i * (i + 1) / 2 + j] : second[j * (j + 1) / 2 + i];
    }

    constexpr SecondDual& operator+=(const SecondDual& b) { return *this = *this + b; }
    constexpr SecondDual& operator-=(const SecondDual& b) { return *this = *this - b; }
    constexpr SecondDual& operator*=(const SecondDual& b) { return *this = *this * b; }
    constexpr SecondDual& operator/=(const SecondDual& b) { return *this = *this / b; }

    friend constexpr SecondDual operator+(const SecondDual& a, const SecondDual& b) {
        return sum(a.value + b.value, a, T(1), b, T(1));
    }
    friend constexpr SecondDual operator-(const SecondDual& a, const SecondDual& b) {
        return sum(a.value - b.value, a, T(1), b, T(-1));
    }
    friend constexpr SecondDual operator+(const SecondDual& a) { return a; }
    friend constexpr SecondDual operator-(const SecondDual& a) { return chain(a, -a.value, T(-1), T(0)); }
    friend constexpr SecondDual operator*(const SecondDual& a, const SecondDual& b) {
        SecondDual r = sum(a.value * b.value, a, b.value, b, a.value);
        if constexpr (wide) {
            detail::add_wide_products(N, r.second.data(), a.first.data(), b.first.data());
            return r;
        }
        std::size_t at = 0;
        for (std::size_t i = 0; i < N; ++i)
            for (std::size_t j = 0; j <= i; ++j)
                r.second[at++] += a.first[i] * b.first[j] + a.first[j] * b.first[i];
        return r;
    }
    friend constexpr SecondDual operator/(const SecondDual& a, const SecondDual& b) {
        const T inverse = T(1) / b.value;
        SecondDual r = a * chain(b, inverse, -inverse * inverse, T(2) * inverse * inverse * inverse);
        r.value = a.value / b.value;
        return r;
    }

    friend constexpr bool operator<(const SecondDual& a, const SecondDual& b) { return a.value < b.value; }
    friend constexpr bool operator>(const SecondDual& a, const SecondDual& b) { return a.value > b.value; }
    friend constexpr bool operator<=(const SecondDual& a, const SecondDual& b) { return a.value <= b.value; }
    friend constexpr bool operator>=(const SecondDual& a, const SecondDual& b) { return a.value >= b.value; }
    friend constexpr bool operator==(const SecondDual& a, const SecondDual& b) { return a.value == b.value; }

    /// A function of one argument: value, first and second derivative there.
    static constexpr SecondDual chain(const SecondDual& a, const T& f, const T& df, const T& ddf) {
        if constexpr (wide) {
            SecondDual r;
            r.value = f;
            for (std::size_t i = 0; i < N; ++i)
                r.first[i] = df * a.first[i];
            detail::wide_chain(N, r.second.data(), a.second.data(), a.first.data(), df, ddf);
            return r;
        }
        SecondDual r(f);
        std::size_t at = 0;
        for (std::size_t i = 0; i < N; ++i) {
            r.first[i] = df * a.first[i];
            for (std::size_t j = 0; j <= i; ++j, ++at)
                r.second[at] = df * a.second[at] + ddf * a.first[i] * a.first[j];
        }
        return r;
    }

    /// A function of two arguments: value, the gradient (fa, fb) and the second derivatives there.
    static constexpr SecondDual chain(const SecondDual& a, const SecondDual& b, const T& f, const T& fa, const T& fb,
                                      const T& faa, const T& fab, const T& fbb) {
        SecondDual r = sum(f, a, fa, b, fb);
        if constexpr (wide) {
            detail::add_wide_chain(N, r.second.data(), a.first.data(), b.first.data(), faa, fab, fbb);
            return r;
        }
        std::size_t at = 0;
        for (std::size_t i = 0; i < N; ++i)
            for (std::size_t j = 0; j <= i; ++j)
                r.second[at++] += faa * a.first[i] * a.first[j] + fbb * b.first[i] * b.first[j] +
                                  fab * (a.first[i] * b.first[j] + a.first[j] * b.first[i]);
        return r;
    }

    /// A value `f` whose derivatives are those of ka a + kb b.
    static constexpr SecondDual sum(const T& f, const SecondDual& a, const T& ka, const SecondDual& b, const T& kb) {
        if constexpr (wide) {
            SecondDual r;
            r.value = f;
            detail::wide_sum(N, r.first.data(), a.first.data(), ka, b.first.data(), kb);
            detail::wide_sum(pairs, r.second.data(), a.second.data(), ka, b.second.data(), kb);
            return r;
        }
        SecondDual r(f);
        for (std::size_t i = 0; i < N; ++i)
            r.first[i] = ka * a.first[i] + kb * b.first[i];
        for (std::size_t k = 0; k < pairs; ++k)
            r.second[k] = ka * a.second[k] + kb * b.second[k];
        return r;
    }
};

template <class T, std::size_t N>
constexpr const T& value_of(const SecondDual<T, N>& x) {
    return x.value;
}

// f' = 1 / (2 f), f'' = -1 / (4 f a)
template <class T, std::size_t N>
SecondDual<T, N> sqrt(const SecondDual<T, N>& a) {
    using std::sqrt;
    const T root = sqrt(a.value);
    if (!(root > T(0))) return SecondDual<T, N>(root);
    return SecondDual<T, N>::chain(a, root, T(0.5) / root, T(-0.25) / (root * a.value));
}

// f' = cos, f'' = -sin
template <class T, std::size_t N>
SecondDual<T, N> sin(const SecondDual<T, N>& a) {
    const auto [sine, cosine] = sine_and_cosine(a.value);
    return SecondDual<T, N>::chain(a, sine, cosine, -sine);
}

// f' = -sin, f'' = -cos
template <class T, std::size_t N>
SecondDual<T, N> cos(const SecondDual<T, N>& a) {
    const auto [sine, cosine] = sine_and_cosine(a.value);
    return SecondDual<T, N>::chain(a, cosine, -sine, -cosine);
}

template <class T, std::size_t N>
SineAndCosine<SecondDual<T, N>> sine_and_cosine(const SecondDual<T, N>& a) {
    const auto [sine, cosine] = sine_and_cosine(a.value);
    return {SecondDual<T, N>::chain(a, sine, cosine, -sine), SecondDual<T, N>::chain(a, cosine, -sine, -cosine)};
}

// f' = sign(a), f'' = 0
template <class T, std::size_t N>
SecondDual<T, N> abs(const SecondDual<T, N>& a) {
    return a.value < T(0) ? -a : a;
}

// With u = a / h, v = b / h: f_a = u, f_b = v, f_aa = v^2 / h, f_ab = -u v / h, f_bb = u^2 / h
template <class T, std::size_t N>
SecondDual<T, N> hypot(const SecondDual<T, N>& a, const SecondDual<T, N>& b) {
    const T h = hypotenuse(a.value, b.value);
    if (!(h > T(0))) return SecondDual<T, N>(h);
    const T u = a.value / h;
    const T v = b.value / h;
    return SecondDual<T, N>::chain(a, b, h, u, v, v * v / h, -u * v / h, u * u / h);
}

// With h = hypot(y, x), s = y / h, c = x / h: f_y = c / h, f_x = -s / h, f_yy = -2 s c / h^2, f_yx = (s^2 - c^2) / h^2,
// f_xx = 2 s c / h^2
template <class T, std::size_t N>
SecondDual<T, N> atan2(const SecondDual<T, N>& y, const SecondDual<T, N>& x) {
    using std::atan2;
    const T h = hypotenuse(x.value, y.value);
    const T angle = atan2(y.value, x.value);
    if (!(h > T(0))) return SecondDual<T, N>(angle);
    const T s = (y.value / h) / h;
    const T c = (x.value / h) / h;
    return SecondDual<T, N>::chain(y, x, angle, c, -s, T(-2) * s * c, (s - c) * (s + c), T(2) * s * c);
}

/// (a + b) - (c + d), the value compensated (scalar.h).
template <class T, std::size_t N>
SecondDual<T, N> sum_difference(const SecondDual<T, N>& a, const SecondDual<T, N>& b, const SecondDual<T, N>& c,
                                const SecondDual<T, N>& d) {
    SecondDual<T, N> r = (a + b) - (c + d);
    r.value = sum_difference(a.value, b.value, c.value, d.value);
    return r;
}

}  // namespace mechwright
