#pragma once
/// \file
/// Cams with flat-faced followers, translating (the face square to its motion) and oscillating. The cam centre is the
/// origin. The cam is the envelope of the face: its support function gives contact and radius of curvature.

#include <cmath>

#include "analysis/cam/contour.h"
#include "analysis/cam/law.h"
#include "analysis/geometry/half_angle.h"
#include "analysis/geometry/vector.h"

namespace mechwright::cam {

/// The face is square to the guide; where along the face the guide stands makes no difference to the cam.
template <class T>
struct TranslatingFlat {
    T base_radius;
    int sense = 1;  ///< of the cam: +1 counter-clockwise, -1 clockwise
};

/// A face that turns about a pivot at (pivot_distance, 0) and lies `face_offset` from it, > 0 on the side of the cam.
/// The face turns clockwise in a rise: against a cam that turns counter-clockwise.
template <class T>
struct OscillatingFlat {
    T base_radius;
    T pivot_distance;
    T face_offset;
    int sense = 1;
};

template <class T>
struct FaceContact {
    Vector<T> position;  ///< where cam and face touch, in the fixed plane
    Vector<T> normal;    ///< unit vector from the cam to the face
    T radius;            ///< of curvature of the cam, > 0 where it is convex; may be 0 or negative: then it is no cam
    T along;             ///< place of the contact along the face, from the guide or from the pivot's foot
    T pressure_angle;
    T margin;  ///< > 0 where the face follows the cam: 1 + sense * arm velocity, or 1
};

template <class T>
FaceContact<T> face_contact(const TranslatingFlat<T>& f, const Lift<T>& lift) {
    const T height = f.base_radius + lift.s;
    const T one(Constant<T>(1));
    return {{f.sense > 0 ? lift.v : -lift.v, height}, {T(), one}, height + lift.a, lift.v, T(), one};
}

template <class T>
FaceContact<T> face_contact(const ContourFlat<T>& f, const Lift<T>& lift) {
    return face_contact(TranslatingFlat<T>{f.base_radius, f.sense}, lift);
}

/// Angle of the face to the line from pivot to cam centre at the lowest position; between 0 and a right angle.
/// Precondition: base_radius + face_offset <= pivot_distance, and > 0.
template <class T>
T face_start(const OscillatingFlat<T>& f) {
    using std::atan2;
    const T sine = f.base_radius + f.face_offset;
    return atan2(sine, root_or_zero(T((f.pivot_distance - sine) * (f.pivot_distance + sine))));
}

/// Where along an oscillating face the foot of the cam centre is, from the pivot's foot. While the face turns against
/// the cam the contact is on the same side, for it is at this over the turning: where it is not > 0 the contact is at
/// the pivot's foot or beyond, and the cam's push no longer turns the face. That is where start angle and lift together
/// reach a right angle.
template <class T>
T foot_along_face(const OscillatingFlat<T>& f, const Lift<T>& lift) {
    using std::cos;
    return f.pivot_distance * cos(T(face_start(f) + lift.s));
}

/// Precondition: 1 + sense * velocity differs from 0.
template <class T>
FaceContact<T> face_contact(const OscillatingFlat<T>& f, const Lift<T>& lift) {
    using std::atan2, std::cos, std::sin;
    const T angle = face_start(f) + lift.s;
    const T cosine = cos(angle), sine = sin(angle);
    const T one(Constant<T>(1)), sense(Constant<T>(f.sense));
    const T turning = one + sense * lift.v;  // of the face against the cam, over that of the cam
    const T along = f.pivot_distance * cosine / turning;
    const Vector<T> normal{sine, cosine}, tangent{-cosine, sine};
    const Vector<T> pivot{f.pivot_distance, T()};
    const T radius = f.pivot_distance * sine * (turning + sense * lift.v) / (turning * turning) +
                     f.pivot_distance * cosine * lift.a / (turning * turning * turning) - f.face_offset;
    return {
        pivot + along * tangent - f.face_offset * normal, normal, radius, along, atan2(f.face_offset, along), turning};
}

}  // namespace mechwright::cam
