#pragma once
/// \file
/// The motion of the ram for any mechanism that drives one, as functions of the crank angle: `Drive` is SliderCrank,
/// CrankShaper, Whitworth or DragLink in some number type. For unit crank speed velocity and acceleration are the
/// first and second derivatives of the position.

#include "analysis/numbers/dual.h"
#include "analysis/quick_return/crank_shaper.h"
#include "analysis/quick_return/drag_link.h"
#include "analysis/quick_return/whitworth.h"

namespace mechwright {

/// The slider-crank at the end of a drive's pose, of its velocity, of its acceleration.
template <class T>
const SliderCrankPose<T>& ram_of(const SliderCrankPose<T>& p) {
    return p;
}
template <class T>
const SliderCrankVelocity<T>& ram_of(const SliderCrankVelocity<T>& v) {
    return v;
}
template <class T>
const SliderCrankAcceleration<T>& ram_of(const SliderCrankAcceleration<T>& a) {
    return a;
}
template <class State>
const auto& ram_of(const State& state) {
    return state.output;
}

template <class T>
SliderCrank<T> output_of(const SliderCrank<T>& m) {
    return m;
}

/// The pose of a drive at a crank angle in radians.
template <class Drive, class T>
auto pose_at(const Drive& m, const T& crank_angle) {
    if constexpr (requires { pose(m, half_turn(crank_angle)); })
        return pose(m, half_turn(crank_angle));
    else
        return pose(m, crank_angle);
}

template <class Drive, class T>
T ram_position(const Drive& m, const T& crank_angle) {
    return ram_of(pose_at(m, crank_angle)).position;
}

template <class Drive, class T>
T ram_velocity(const Drive& m, const T& crank_angle) {
    return ram_of(velocity(m, pose_at(m, crank_angle))).ram;
}

template <class Drive, class T>
T ram_acceleration(const Drive& m, const T& crank_angle) {
    const auto p = pose_at(m, crank_angle);
    return ram_of(acceleration(m, p, velocity(m, p))).ram;
}

/// The derivative of the acceleration.
template <class Drive>
double ram_jerk(const Drive& m, double crank_angle) {
    using Rate = Dual<double, 1>;
    return ram_acceleration(converted<Rate>(m), Rate::variable(crank_angle, 0)).partial[0];
}

}  // namespace mechwright
