#pragma once
/// \file
/// Velocities and accelerations of a four-bar, each from the pose below it. Reference: Theory of Machines, equations
/// (4-39), (4-40) for velocities, (4-44), (4-45) for accelerations, with sin(rocker - coupler) taken from the pose.

#include "analysis/four_bar/pose.h"

namespace mechwright {

/// Angular velocities, in the unit of the crank's. Infinite at a toggle, where the sine of the transmission angle is 0:
/// callers look at the margins first.
template <class T>
struct FourBarVelocity {
    T crank;
    T coupler;
    T rocker;
};

template <class T>
FourBarVelocity<T> velocity(const FourBar<T>& m, const FourBarPose<T>& p, const T& crank_velocity = T(1)) {
    const T pin = m.crank * crank_velocity / p.transmission_sine;
    return {crank_velocity, pin * cross(p.rocker, p.crank) / m.coupler, pin * cross(p.coupler, p.crank) / m.rocker};
}

/// Angular accelerations.
template <class T>
struct FourBarAcceleration {
    T crank;
    T coupler;
    T rocker;
};

template <class T>
FourBarAcceleration<T> acceleration(const FourBar<T>& m, const FourBarPose<T>& p, const FourBarVelocity<T>& v,
                                    const T& crank_acceleration = T(0)) {
    const T crank_square = m.crank * v.crank * v.crank;
    const T coupler_square = m.coupler * v.coupler * v.coupler;
    const T rocker_square = m.rocker * v.rocker * v.rocker;
    const T tangential = m.crank * crank_acceleration;
    const T rocker = (tangential * cross(p.coupler, p.crank) + crank_square * dot(p.coupler, p.crank) + coupler_square -
                      rocker_square * p.transmission_cosine) /
                     (m.rocker * p.transmission_sine);
    const T coupler = (tangential * cross(p.rocker, p.crank) + crank_square * dot(p.rocker, p.crank) +
                       coupler_square * p.transmission_cosine - rocker_square) /
                      (m.coupler * p.transmission_sine);
    return {crank_acceleration, coupler, rocker};
}

}  // namespace mechwright
