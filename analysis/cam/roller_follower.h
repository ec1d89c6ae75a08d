#pragma once
/// \file
/// Cams with roller followers, translating and oscillating; a knife edge is a roller of radius 0. The cam centre is the
/// origin. A frame that goes with the follower makes both alike: its y axis is the direction in which the roller centre
/// moves in a rise, and in it the tangent of the pitch curve is (across, along), so that the pressure angle is the
/// direction of that vector. Everything follows from the pitch point p in the fixed plane as a complex number: the cam
/// turning with sense sigma (+1 counter-clockwise) sees p' - i sigma p and p'' - 2 i sigma p' - p.

#include <cmath>

#include "analysis/cam/contour.h"
#include "analysis/cam/law.h"
#include "analysis/geometry/half_angle.h"
#include "analysis/geometry/vector.h"
#include "analysis/numbers/scalar.h"

namespace mechwright::cam {

/// A follower whose roller centre moves along a straight line. `offset` > 0 lies on the side that relieves the rise:
/// to the right of the cam centre if the cam turns counter-clockwise and the follower rises upward.
template <class T>
struct TranslatingRoller {
    T prime_radius;
    T offset;
    T roller_radius;
    int sense = 1;  ///< of the cam: +1 counter-clockwise, -1 clockwise
};

/// An arm about a pivot at (pivot_distance, 0), the roller above the line to the cam centre. The arm turns clockwise in
/// a rise: against a cam that turns counter-clockwise. Lift is the angle from the arm's lowest position.
template <class T>
struct OscillatingRoller {
    T prime_radius;
    T pivot_distance;
    T arm_length;
    T roller_radius;
    int sense = 1;
};

/// The pitch curve at one position of the cam.
template <class T>
struct PitchPoint {
    Vector<T> position;  ///< of the roller centre, in the fixed plane
    Vector<T> frame;     ///< x axis of the follower's frame, a unit vector of the fixed plane
    T across;            ///< of the tangent along the pitch curve, in the follower's frame; > 0
    T along;
    T bend;  ///< curvature times the cube of the tangent's length, > 0 where the pitch curve is convex
    int sense;
};

/// Distance of the roller centre from the foot of the cam centre on the guide, at the lowest position.
/// Precondition: |offset| <= prime_radius.
template <class T>
T guide_height(const TranslatingRoller<T>& f) {
    return root_or_zero(T((f.prime_radius - f.offset) * (f.prime_radius + f.offset)));
}

template <class T>
PitchPoint<T> pitch_point(const TranslatingRoller<T>& f, const Lift<T>& lift) {
    const T across = guide_height(f) + lift.s;
    const T along = lift.v - f.offset;
    return {{f.sense > 0 ? f.offset : -f.offset, across},
            {T(Constant<T>(1)), T()},
            across,
            along,
            across * (across - lift.a) + along * (along + lift.v),
            f.sense};
}

template <class T>
PitchPoint<T> pitch_point(const ContourRoller<T>& f, const Lift<T>& lift) {
    return pitch_point(TranslatingRoller<T>{f.base_radius + f.roller_radius, T(), f.roller_radius, f.sense}, lift);
}

/// The angle of the arm to the line from pivot to cam centre at the lowest position.
/// Precondition: the prime radius makes a triangle with pivot distance and arm length.
template <class T>
HalfAngle<T> arm_start(const OscillatingRoller<T>& f) {
    const T difference = f.pivot_distance - f.arm_length, sum = f.pivot_distance + f.arm_length;
    return half_angle_of_squares(T((f.prime_radius - difference) * (f.prime_radius + difference)),
                                 T((sum - f.prime_radius) * (sum + f.prime_radius)));
}

template <class T>
PitchPoint<T> pitch_point(const OscillatingRoller<T>& f, const Lift<T>& lift) {
    using std::cos, std::sin;
    const T arm = angle(arm_start(f)) + lift.s;
    const T cosine = cos(arm), sine = sin(arm);
    const T one(Constant<T>(1)), sense(Constant<T>(f.sense));
    const T turning = one + sense * lift.v;
    const T across = f.pivot_distance * sine;
    const T along = f.arm_length * (lift.v + sense) - sense * f.pivot_distance * cosine;
    return {{f.pivot_distance - f.arm_length * cosine, f.arm_length * sine},
            {cosine, -sine},
            across,
            along,
            across * (across - f.arm_length * lift.a) +
                sense * along * (f.arm_length * turning * turning - f.pivot_distance * cosine),
            f.sense};
}

/// Angle from the normal to the direction in which the roller centre moves: > 0 where a rise is pushed from the side.
template <class T>
T pressure_angle(const PitchPoint<T>& p) {
    using std::atan2;
    return atan2(p.along, p.across);
}

/// Of the pitch curve, > 0 where it is convex.
template <class T>
T curvature(const PitchPoint<T>& p) {
    const T speed = hypotenuse(p.across, p.along);
    return p.bend / (speed * speed * speed);
}

/// The unit normal of the cam at the contact, from the cam to the roller, in the fixed plane.
template <class T>
Vector<T> normal(const PitchPoint<T>& p) {
    const T speed = hypotenuse(p.across, p.along);
    const T tilt = p.along / speed;
    return turned(Vector<T>{p.sense > 0 ? -tilt : tilt, p.across / speed}, p.frame);
}

/// Where cam and roller touch, in the fixed plane.
template <class T>
Vector<T> contact_point(const PitchPoint<T>& p, const T& roller_radius) {
    return p.position - roller_radius * normal(p);
}

}  // namespace mechwright::cam
