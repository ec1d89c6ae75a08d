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

/// Numbers of a dyad that is carried round (CarriedRound), which depend on dimensions alone, in a row of them. With the
/// crank r, the frame g from its centre to the fixed pin and the angle t between the two, the distance d of the outer
/// pins follows without cancellation: d^2 = (g - r)^2 + 2 g r (1 - cos t) = (g + r)^2 - 2 g r (1 + cos t), where the
/// lesser of 1 -+ cos t is sin^2 t / (1 + |cos t|). Margins are counted from the nearer of the two positions in line
/// with the frame, where they are compensated sums of four lengths: the formulas of four_bar/pose_formulas.h for any
/// place of the pins.
template <class T>
struct RoundDyad {
    enum Position : std::size_t {
        ground_x,  ///< the direction from the centre to the fixed pin; turned round where the dyad's first pin is fixed
        ground_y,
        lead_x,  ///< what the crank's x axis is turned by to its arm's direction against the ground
        lead_y,
        frame,
        crank,
        twice_product,
        nearest,  ///< distances of the outer pins in line
        farthest,
        stretch_nearest,  ///< margins there
        stretch_farthest,
        fold_nearest,
        fold_farthest,
        twice_lesser,
        per_first,  ///< 1 over four times the length of a link
        per_second,
        count
    };
    const T* row;

    const T& operator[](Position i) const { return row[i]; }
    Vector<T> ground() const { return {row[ground_x], row[ground_y]}; }
    Vector<T> lead() const { return {row[lead_x], row[lead_y]}; }
};

/// Whether a dyad that is carried round is placed by its own formulas: where sums are compensated. Other number types
/// take those of any two circles, in fewer operations.
template <class T>
inline constexpr bool goes_round = plain_doubles<T>;

/// The direction of a vector; the x axis where it has none.
template <class T>
Vector<T> any_direction(const Vector<T>& of, const T& length) {
    const auto has_one = length > T(0);
    const T per = T(1) / select(has_one, length, T(1));
    return {select(has_one, T(per * of.x), T(1)), T(per * of.y)};
}

/// Writes the numbers of a RoundDyad: `arm` leads from the centre to the pin that goes round, in the frame of the
/// crank, `base` from there to the fixed pin, a and b are the lengths of the first and the second link.
template <class T>
void put_round_dyad(const Vector<T>& arm, const Vector<T>& base, const T& a, const T& b, bool first_is_fixed, T* row) {
    using D = RoundDyad<T>;
    using std::abs;
    const T frame = hypotenuse(base.x, base.y), crank = hypotenuse(arm.x, arm.y);
    const Vector<T> direction = any_direction(base, frame), ground = first_is_fixed ? -direction : direction,
                    lead = turned(any_direction(arm, crank), conjugate(direction));
    row[D::ground_x] = ground.x;
    row[D::ground_y] = ground.y;
    row[D::lead_x] = lead.x;
    row[D::lead_y] = lead.y;
    row[D::frame] = frame;
    row[D::crank] = crank;
    row[D::twice_product] = T(2) * frame * crank;
    row[D::nearest] = abs(T(frame - crank));
    row[D::farthest] = frame + crank;
    const auto frame_longer = frame >= crank, longer = a >= b;
    const T outer = select(frame_longer, frame, crank), inner = select(frame_longer, crank, frame);
    const T greater = select(longer, a, b), lesser = select(longer, b, a);
    row[D::stretch_nearest] = sum_difference(greater, lesser, outer, T(-inner));
    row[D::stretch_farthest] = sum_difference(greater, lesser, outer, inner);
    row[D::fold_nearest] = sum_difference(outer, lesser, greater, inner);
    row[D::fold_farthest] = sum_difference(outer, lesser, greater, T(-inner));
    row[D::twice_lesser] = T(2) * lesser;
    row[D::per_first] = T(1) / (T(4) * a);
    row[D::per_second] = T(1) / (T(4) * b);
}

/// Two circles: the law of cosines with every factor of its half-angle formulas taken from the margins, as in
/// four_bar/pose_formulas.h. `side` 1: the pin lies to the left of the line from the first centre to the second.
/// Directions are calculated when they are asked for. All of it is made part of what asks: handed over through memory
/// it takes a fifth longer.
template <class T>
struct Circles {
    T a, b;                   ///< radii
    T per_first, per_second;  ///< 1 over four times the radius and the distance of the centres
    T sum, a_side, b_side, double_root;
    Vector<T> along, across;
    Margin<T> margin;

    [[gnu::always_inline]] Circles(const Vector<T>& first, const Vector<T>& second, const T& first_radius,
                                   const T& second_radius, const T& side)
        : a(first_radius), b(second_radius) {
        using std::abs;
        const Vector<T> apart = second - first;
        const T d = hypotenuse(apart.x, apart.y), inverse = T(1) / d;
        const T difference = abs(T(a - b)), total = a + b;
        margin = {total - d, determined(T(d - difference), inverse)};
        per_first = inverse / (T(4) * a);
        per_second = inverse / (T(4) * b);
        take_sides(T(total + d), T(d + difference));
        along = inverse * apart;
        across = side * left_of(along);
    }
    /// Of a dyad that is carried round, by the direction of the crank's x axis.
    [[gnu::always_inline]] Circles(const RoundDyad<T>& of, const Vector<T>& crank, const T& first_radius,
                                   const T& second_radius, const T& side)
        : a(first_radius), b(second_radius) {
        using D = RoundDyad<T>;
        using std::abs, std::sqrt;
        const Vector<T> arm = turned(crank, of.lead());
        const auto is_near = arm.x >= T(0);
        const T versed = arm.y * arm.y / (T(1) + abs(arm.x)), grown_square = of[D::twice_product] * versed;
        const T start = select(is_near, of[D::nearest], of[D::farthest]);
        const T change = select(is_near, grown_square, T(-grown_square));
        const T d = sqrt(T(start * start + change)), inverse = T(1) / d, grown = change / (d + start);
        // Together they are twice the lesser link. With the greater margin taken from that, the two are rounded alike
        // and the direction of a very short link keeps its unit length.
        const T stretch = select(is_near, of[D::stretch_nearest], of[D::stretch_farthest]) - grown,
                fold = select(is_near, of[D::fold_nearest], of[D::fold_farthest]) + grown;
        const auto fold_least = stretch > fold;
        margin = {select(fold_least, T(of[D::twice_lesser] - fold), stretch),
                  determined(select(fold_least, fold, T(of[D::twice_lesser] - stretch)), inverse)};
        per_first = inverse * of[D::per_first];
        per_second = inverse * of[D::per_second];
        take_sides(T(a + b + d), T(d + abs(T(a - b))));
        const T &r = of[D::crank], &g = of[D::frame];
        const T forward = select(is_near, T((g - r) + r * versed), T(g - r * arm.x));
        along = inverse * turned(Vector<T>{forward, T(-(r * arm.y))}, of.ground());
        across = side * left_of(along);
    }
    /// The unit vector from the first centre to the pin.
    [[gnu::always_inline]] Vector<T> from_first() const {
        const T cosine = (sum * a_side - margin.outer * b_side) * per_first;
        return cosine * along + T(double_root * per_first) * across;
    }
    /// From the second centre.
    [[gnu::always_inline]] Vector<T> from_second() const {
        const T cosine = (sum * b_side - margin.outer * a_side) * per_second;
        return T(double_root * per_second) * across - cosine * along;
    }

private:
    [[gnu::always_inline]] void take_sides(const T& all, const T& other) {
        sum = all;
        const auto longer = a >= b;
        a_side = select(longer, other, margin.inner);
        b_side = select(longer, margin.inner, other);
        double_root = T(2) * root_or_zero(T((margin.outer * sum) * (margin.inner * other)));
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
