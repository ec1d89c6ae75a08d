#pragma once
/// \file
/// Cams of a specified contour: base circle, two straight or circular flanks and a circular nose, or one eccentric
/// circle. The lift follows from the contour, circle by circle: with a roller it is that of a slider-crank whose crank
/// is the distance of the circle's centre and whose rod is its radius and the roller's together. The cycle begins where
/// the flank leaves the base circle.

#include <array>
#include <cmath>

#include "analysis/cam/law.h"
#include "analysis/geometry/half_angle.h"

namespace mechwright::cam {

enum class ContourKind { none, tangent, circular_arc, eccentric };

/// Lengths from the cam centre. An eccentric circle has the radius base_radius + centre_distance; its nose and flank
/// count for nothing. Flanks of a tangent cam are straight: flank_radius counts for nothing.
template <class T>
struct Contour {
    ContourKind kind = ContourKind::none;
    T base_radius{};
    T nose_radius{};
    T centre_distance{};  ///< of the nose circle's or the eccentric circle's centre
    T flank_radius{};
    T roller_radius{};
    bool roller = true;  ///< else a flat face
    T rise{};            ///< cam angle from the end of the base circle to the top of the nose: half the action angle
    T flank{};           ///< cam angle at which the contact passes from flank to nose
};

inline constexpr std::size_t contour_pieces = 5;

inline std::size_t pieces(ContourKind kind) { return kind == ContourKind::eccentric ? 1 : contour_pieces; }

namespace detail {

template <class T>
T rise_angle(const Contour<T>& c) {
    // By the half angle: 1 - cos and 1 + cos have the lift as a factor, or its like with base and nose exchanged.
    const T lift = c.centre_distance + (c.nose_radius - c.base_radius);
    const T other = c.centre_distance - (c.nose_radius - c.base_radius);
    if (c.kind == ContourKind::tangent) return angle(half_angle_of_squares(lift, other));
    const T flanks = T(Constant<T>(2)) * c.flank_radius - c.base_radius - c.nose_radius;
    return angle(
        half_angle_of_squares(T(lift * (flanks + c.centre_distance)), T(other * (flanks - c.centre_distance))));
}

/// Precondition: the rise angle is there.
template <class T>
T flank_angle(const Contour<T>& c) {
    using std::atan2, std::cos, std::sin;
    const T x = c.centre_distance * sin(c.rise);
    if (c.kind == ContourKind::tangent) return atan2(x, c.base_radius + c.roller_radius);
    // The common normal of flank and nose, from the flank's centre through the nose's.
    const T flank = c.flank_radius - c.base_radius;
    const T y = c.centre_distance * cos(c.rise) + flank;
    if (!c.roller) return atan2(x, y);
    const T reach = (c.flank_radius + c.roller_radius) / (c.flank_radius - c.nose_radius);
    return atan2(reach * x, reach * y - flank);
}

}  // namespace detail

/// A contour of these lengths with its angles. Precondition: the circles meet as the kind of contour wants it, else
/// angles are 0 or pi.
template <class T>
Contour<T> completed(Contour<T> c) {
    if (c.kind == ContourKind::tangent || c.kind == ContourKind::circular_arc) {
        c.rise = detail::rise_angle(c);
        c.flank = detail::flank_angle(c);
    }
    return c;
}

template <class T>
T total_lift(const Contour<T>& c) {
    if (c.kind == ContourKind::eccentric) return T(Constant<T>(2)) * c.centre_distance;
    return c.centre_distance + c.nose_radius - c.base_radius;
}

namespace detail {

/// On a circle whose centre lies `distance` from the axis, at the angle g before the follower: derivatives in the cam
/// angle, in which g falls.
template <class T>
Lift<T> on_circle(const Contour<T>& c, const T& distance, const T& radius, const T& g) {
    using std::cos, std::sin, std::sqrt;
    const T two(Constant<T>(2)), sine = sin(g), cosine = cos(g);
    Lift<T> lift{distance * cosine, distance * sine, -distance * cosine, -distance * sine};
    if (!c.roller) {
        lift.s += radius - c.base_radius;
        return lift;
    }
    // q = sqrt(rod^2 - (distance sin g)^2); with w = q^2: 2 q q' = w', and so on.
    const T rod = radius + c.roller_radius, square = distance * distance;
    const T double_sine = two * sine * cosine, double_cosine = cosine * cosine - sine * sine;
    const T q = sqrt((rod - distance * sine) * (rod + distance * sine));
    const T first = -square * double_sine / (two * q);
    const T second = (-two * square * double_cosine - two * first * first) / (two * q);
    const T third = (T(Constant<T>(4)) * square * double_sine - T(Constant<T>(6)) * first * second) / (two * q);
    lift.s += q - c.base_radius - c.roller_radius;
    lift.v -= first;
    lift.a += second;
    lift.j -= third;
    return lift;
}

/// On the flank, at cam angle t after the base circle.
template <class T>
Lift<T> on_flank(const Contour<T>& c, const T& t) {
    using std::cos, std::sin;
    if (c.kind == ContourKind::circular_arc)
        return on_circle(c, T(c.flank_radius - c.base_radius), c.flank_radius, T(pi<Constant<T>>() - t));
    const T one(Constant<T>(1)), two(Constant<T>(2)), six(Constant<T>(6));
    const T reach = c.base_radius + c.roller_radius, secant = one / cos(t), tangent = sin(t) * secant;
    return {reach * (secant - one), reach * secant * tangent, reach * secant * (two * secant * secant - one),
            reach * secant * tangent * (six * secant * secant - one)};
}

}  // namespace detail

/// The lift on a piece (flank, nose, nose, flank, base circle, or the whole eccentric circle) at `part` of it, 0 to 1.
template <class T>
Lift<T> lift_at(const Contour<T>& c, std::size_t piece, const T& part) {
    if (c.kind == ContourKind::eccentric) {
        const T g = T(pi<Constant<T>>()) - T(Constant<T>(2) * pi<Constant<T>>()) * part;
        return detail::on_circle(c, c.centre_distance, T(c.base_radius + c.centre_distance), g);
    }
    const T &psi = c.flank, &alpha = c.rise;
    const T one(Constant<T>(1));
    switch (piece) {
        case 0: return detail::on_flank(c, T(part * psi));
        case 1:
        case 2: {
            const T half = alpha - psi;
            return detail::on_circle(c, c.centre_distance, c.nose_radius,
                                     T(piece == 1 ? (one - part) * half : -part * half));
        }
        case 3: {
            const Lift<T> mirrored = detail::on_flank(c, T((one - part) * psi));
            return {mirrored.s, -mirrored.v, mirrored.a, -mirrored.j};
        }
        default: return {};
    }
}

/// Cam angles at which the pieces begin, and 2 pi.
template <class T>
std::array<T, contour_pieces + 1> piece_angles(const Contour<T>& c) {
    const T turn(Constant<T>(2) * pi<Constant<T>>());
    if (c.kind == ContourKind::eccentric) return {T(), turn, turn, turn, turn, turn};
    const T two(Constant<T>(2));
    return {T(), c.flank, c.rise, two * c.rise - c.flank, two * c.rise, turn};
}

/// A roller on such a cam, moving radially.
template <class T>
struct ContourRoller {
    T base_radius;
    T nose_radius;
    T centre_distance;
    T flank_radius;
    T roller_radius;
    int sense = 1;
};

/// A flat face on such a cam. Its flanks must not be straight.
template <class T>
struct ContourFlat {
    T base_radius;
    T nose_radius;
    T centre_distance;
    T flank_radius;
    int sense = 1;
};

}  // namespace mechwright::cam
