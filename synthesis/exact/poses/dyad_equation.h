#pragma once
/// \file
/// The equation of a dyad (dyads.h) over any number type: one condition on its pivots.

#include <array>
#include <cstddef>

#include "analysis/geometry/vector.h"

namespace mechwright {

/// What a displacement asks of a dyad: the factors of 1, a.x, a.y, x.x, x.y, Re(x conj(a)), Im(x conj(a)). `turn` is
/// (cos, sin).
template <class T>
std::array<T, 7> dyad_factors(const Vector<T>& shift, const Vector<T>& turn) {
    const Vector<T> moving{dot(shift, turn), cross(shift, turn)};  // conj(shift) turn
    // 1 - cos keeps its digits for small turns.
    const T versine = turn.x > 0 ? T(turn.y * turn.y / (1 + turn.x)) : T(1 - turn.x);
    return {dot(shift, shift) / 2, -shift.x, -shift.y, moving.x, -moving.y, versine, turn.y};
}

/// The factors of what puts the pivot whose coordinates begin at `first` (1: fixed, 3: moving) on the line through a
/// point in a direction of length 1.
template <class T>
std::array<T, 7> line_factors(const Vector<T>& point, const Vector<T>& direction, std::size_t first) {
    std::array<T, 7> factors{};
    factors[first] = -direction.y;
    factors[first + 1] = direction.x;
    factors[0] = -cross(direction, point);
    return factors;
}

/// The value of a condition at a dyad, and its derivatives by a.x, a.y, x.x and x.y.
template <class T>
struct DyadEquation {
    T value;
    std::array<T, 4> slopes;
};

/// `c` is anything with the seven factors as c[0] to c[6]; u, v are a.x, a.y, and p, q are x.x, x.y.
template <class T, class Factors>
DyadEquation<T> dyad_equation(const Factors& c, const T& u, const T& v, const T& p, const T& q) {
    return {c[0] + c[1] * u + c[2] * v + c[3] * p + c[4] * q + c[5] * (p * u + q * v) + c[6] * (q * u - p * v),
            {c[1] + c[5] * p + c[6] * q, c[2] + c[5] * q - c[6] * p, c[3] + c[5] * u - c[6] * v,
             c[4] + c[5] * v + c[6] * u}};
}

}  // namespace mechwright
