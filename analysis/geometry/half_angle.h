#pragma once
/// \file
/// Angles kept as the pair (k sin(a/2), k cos(a/2)), k > 0, 0 <= a <= pi. A triangle gives this pair as square roots of
/// products of sides, without cancellation; the angle itself, its sine and its cosine follow with all their digits,
/// also where the angle is close to 0 or pi (Kahan, "Miscalculating Area and Angles of a Needle-like Triangle").

#include <cmath>

namespace mechwright {

/// sqrt(x), and 0 where x is negative: the caller looks at the margin that made it so.
template <class T>
T root_or_zero(const T& x) {
    using std::sqrt;
    return x > T(0) ? sqrt(x) : T(0);
}

template <class T>
struct HalfAngle {
    T sine;    ///< k sin(a/2), >= 0
    T cosine;  ///< k cos(a/2), >= 0
};

/// The angle a in radians.
template <class T>
T angle(const HalfAngle<T>& half) {
    using std::atan2;
    return T(2) * atan2(half.sine, half.cosine);
}

/// The angle a - b in radians, -pi <= a - b <= pi.
template <class T>
T angle_between(const HalfAngle<T>& a, const HalfAngle<T>& b) {
    using std::atan2;
    return T(2) * atan2(a.sine * b.cosine - a.cosine * b.sine, a.cosine * b.cosine + a.sine * b.sine);
}

/// The angle whose half has a sine and a cosine with these squares, both of them lengths (times anything): written so
/// that lengths multiplied by a power of two change no digit.
template <class T>
HalfAngle<T> half_angle_of_squares(const T& sine_square, const T& cosine_square) {
    const bool acute = sine_square < cosine_square;
    const T product = root_or_zero(T(sine_square * cosine_square));
    if (acute) return {product, cosine_square};
    return {sine_square, product};
}

/// The angle pi - a.
template <class T>
HalfAngle<T> supplement(const HalfAngle<T>& a) {
    return {a.cosine, a.sine};
}

}  // namespace mechwright
