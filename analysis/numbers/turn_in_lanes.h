#pragma once
/// \file
/// Cosine and sine of angles in lanes, by arithmetic alone: the digits are the same in every instruction set.

#include "analysis/geometry/vector.h"
#include "analysis/numbers/lanes.h"

namespace mechwright {

/// (cos a, sin a) for |a| <= 2 pi (radians), to a few units in the last place of 1. The tangent of a/16 is the seventh
/// convergent of its continued fraction (Abramowitz and Stegun, equation 4.3.94), exact here to rounding; the formulas
/// for the double angle do the rest.
template <class T>
Vector<T> unit_vector(const T& a) {
    const T q = T(1.0 / 16) * a;
    const T square = q * q;
    const T above = q * (T(135135.0) - square * (T(17325.0) - square * (T(378.0) - square)));
    const T below = T(135135.0) - square * (T(62370.0) - square * (T(3150.0) - T(28.0) * square));
    const T per = T(1.0) / (below * below + above * above);
    Vector<T> unit{(below * below - above * above) * per, T(2.0) * above * below * per};
    for (int doubled = 0; doubled < 3; ++doubled)
        unit = {unit.x * unit.x - unit.y * unit.y, T(2.0) * unit.x * unit.y};
    return unit;
}

}  // namespace mechwright
