#pragma once
/// \file
/// Complex numbers over any number type, lanes among them: the plain formulas, with no care for overflow, which
/// std::complex pays for.

#include <cmath>

namespace mechwright::homotopy {

template <class T>
struct Complex {
    T re;
    T im;

    friend Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
    friend Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
    friend Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
    friend Complex operator*(const Complex& a, const Complex& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend Complex operator*(const T& a, const Complex& b) { return {a * b.re, a * b.im}; }
};

/// The square of the absolute value.
template <class T>
T norm(const Complex<T>& a) {
    return a.re * a.re + a.im * a.im;
}

template <class T>
Complex<T> inverse(const Complex<T>& a) {
    const T scale = T(1.0) / norm(a);
    return {a.re * scale, -(a.im * scale)};
}

template <class T>
Complex<T> operator/(const Complex<T>& a, const Complex<T>& b) {
    return a * inverse(b);
}

}  // namespace mechwright::homotopy
