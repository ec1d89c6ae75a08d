#pragma once
/// \file
/// Vectors of the plane.

#include <type_traits>

namespace mechwright {

template <class T>
struct Vector {
    T x{};
    T y{};

    friend constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vector operator-(const Vector& a) { return {-a.x, -a.y}; }
    friend constexpr Vector operator*(const T& k, const Vector& a) { return {k * a.x, k * a.y}; }
};

template <class T>
constexpr T dot(const Vector<T>& a, const Vector<T>& b) {
    return a.x * b.x + a.y * b.y;
}

/// The z component of a x b: positive where b lies to the left of a.
template <class T>
constexpr T cross(const Vector<T>& a, const Vector<T>& b) {
    return a.x * b.y - a.y * b.x;
}

/// a turned left by a right angle.
template <class T>
constexpr Vector<T> left_of(const Vector<T>& a) {
    return {-a.y, a.x};
}

/// The product of a and b as complex numbers: a turned by the angle of the unit vector b.
template <class T>
constexpr Vector<T> turned(const Vector<T>& a, const Vector<T>& b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

/// The same where a knows no derivatives that b has.
template <class Number, class T>
requires(!std::is_same_v<Number, T>) constexpr Vector<T> turned(const Vector<Number>& a, const Vector<T>& b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

}  // namespace mechwright
