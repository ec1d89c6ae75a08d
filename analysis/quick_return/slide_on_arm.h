#pragma once
/// \file
/// A slide moved by a second block in the slot of an arm: the block crosses from the arm to a straight slide line at
/// `distance` from the arm pivot. Directions are in the frame of the slide line: x along it, y to its left, the arm
/// pivot at the origin, so that the block stands at y = distance.

#include "analysis/geometry/vector.h"

namespace mechwright {

template <class T>
struct SlideOnArm {
    T position;      ///< along the slide line
    T reach;         ///< from arm pivot to block, along the direction of the arm (negative behind the pivot)
    T velocity;      ///< of the slide
    T sliding;       ///< velocity of the block along the arm
    T coriolis;      ///< acceleration across the arm, to its left
    T acceleration;  ///< of the slide
};

/// `arm` is the unit vector of the arm, not along the slide line; then its angular velocity and acceleration.
/// Derivation: position = distance x / y with (x, y) = arm, differentiated; d(x/y) = -d(angle) / y^2.
template <class T>
SlideOnArm<T> slide_on_arm(const T& distance, const Vector<T>& arm, const T& angular_velocity,
                           const T& angular_acceleration) {
    SlideOnArm<T> s;
    const T cotangent = arm.x / arm.y;
    const T per_square = distance / (arm.y * arm.y);
    s.position = distance * cotangent;
    s.reach = distance / arm.y;
    s.velocity = -per_square * angular_velocity;
    s.sliding = s.velocity * arm.x;
    s.coriolis = T(2) * angular_velocity * s.sliding;
    s.acceleration = per_square * (T(2) * cotangent * angular_velocity * angular_velocity - angular_acceleration);
    return s;
}

}  // namespace mechwright
