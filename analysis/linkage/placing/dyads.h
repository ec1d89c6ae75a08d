#pragma once
/// \file
/// Where two loci meet: the formulas of dyads alone, for everything that places linkages.
///
/// Every dyad is placed by products of its margins, as the four-bar and the slider-crank are: no inverse cosine, no
/// difference of squares. A margin is a length that is negative by what is missing where the dyad does not close, and
/// then the dyad stands at its limit. `side` is 1 or -1, or 0 for a dyad exactly at its limit.

#include <cmath>

#include "analysis/geometry/half_angle.h"
#include "analysis/geometry/vector.h"
#include "analysis/linkage/placing/pose.h"
#include "analysis/numbers/scalar.h"

namespace mechwright::linkage::detail {

/// A line in the frame of the linkage; its direction is a unit vector.
template <class T>
struct PlacedLine {
    Vector<T> through;
    Vector<T> direction;
};

/// A margin, and not a number where two outer pins coincide, so that the dyad could stand anywhere: zero times the
/// inverse of their distance.
template <class T>
T determined(const T& margin, const T& inverse_distance) {
    return margin + T(0) * inverse_distance;
}

/// Two circles: the law of cosines with every factor of its half-angle formulas taken from the margins, as in
/// four_bar/pose_formulas.h. `side` 1: the pin lies to the left of the line from the first centre to the second.
/// Directions are calculated when they are asked for.
template <class T>
struct Circles {
    T a, b;  ///< radii
    T inverse, sum, a_side, b_side, double_root;
    Vector<T> along, across;
    Margin<T> margin;

    Circles(const Vector<T>& first, const Vector<T>& second, const T& first_radius, const T& second_radius,
            const T& side)
        : a(first_radius), b(second_radius) {
        using std::abs;
        const Vector<T> apart = second - first;
        const T d = hypotenuse(apart.x, apart.y);
        const T difference = abs(T(a - b)), total = a + b, other = d + difference;
        sum = total + d;
        inverse = T(1) / d;
        margin = {total - d, determined(T(d - difference), inverse)};
        const auto longer = a >= b;
        a_side = select(longer, other, margin.inner);
        b_side = select(longer, margin.inner, other);
        double_root = T(2) * root_or_zero(T((margin.outer * sum) * (margin.inner * other)));
        along = inverse * apart;
        across = side * left_of(along);
    }
    /// The unit vector from the first centre to the pin.
    Vector<T> from_first() const {
        const T per_a = inverse / (T(4) * a), cosine = (sum * a_side - margin.outer * b_side) * per_a;
        return cosine * along + T(double_root * per_a) * across;
    }
    /// From the second centre.
    Vector<T> from_second() const {
        const T per_b = inverse / (T(4) * b), cosine = (sum * b_side - margin.outer * a_side) * per_b;
        return T(double_root * per_b) * across - cosine * along;
    }
};

/// A circle and a line. `side` 1: the pin lies ahead of the foot of the perpendicular from the centre.
template <class T>
struct CircleAndLine {
    Vector<T> at;           ///< the pin
    Vector<T> from_centre;  ///< the unit vector to it
    T run;                  ///< how far it is ahead of the foot
    Margin<T> margin;

    CircleAndLine(const Vector<T>& centre, const PlacedLine<T>& line, const T& radius, const T& side) {
        const Vector<T> left = left_of(line.direction);
        const T height = dot(left, line.through - centre), per_length = T(1) / radius;
        margin = {radius - height, radius + height};
        run = side * root_or_zero(T(margin.outer * margin.inner));
        at = centre + (run * line.direction + height * left);
        from_centre = T(run * per_length) * line.direction + T(height * per_length) * left;
    }
};

/// Where two lines meet.
template <class T>
Margin<T> meet(const PlacedLine<T>& a, const PlacedLine<T>& b, Vector<T>& at) {
    using std::abs;
    const T sine = cross(a.direction, b.direction);
    at = a.through + T(cross(b.through - a.through, b.direction) / sine) * a.direction;
    const T size = abs(sine), margin = select(size > T(0), size, T(-1));
    return {margin, margin};
}

/// A link on a placed pin whose line, in its own frame at `direction`, passes another placed pin at the distance
/// `height`, to its left. `side` 1: that pin lies ahead of the foot of the perpendicular from the first.
template <class T>
struct Through {
    Vector<T> along;  ///< the x axis of the link
    T inverse, run;   ///< of the distance of the pins; how far the far pin is ahead of the foot
    Margin<T> margin;

    Through(const Vector<T>& pin, const Vector<T>& far_pin, const Vector<T>& direction, const T& height,
            const T& side) {
        const Vector<T> apart = far_pin - pin;
        const T d = hypotenuse(apart.x, apart.y);
        inverse = T(1) / d;
        margin = {determined(T(d - height), inverse), d + height};
        run = side * root_or_zero(T(margin.outer * margin.inner));
        const Vector<T> own = T(run * inverse) * direction + T(height * inverse) * left_of(direction);
        along = turned(inverse * apart, conjugate(own));
    }
};

}  // namespace mechwright::linkage::detail
