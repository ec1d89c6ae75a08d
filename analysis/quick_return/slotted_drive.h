#pragma once
/// \file
/// What the crank shaper and Whitworth's drive have in common: a slotted arm that drives a slider-crank. `Drive` is
/// either of them.

#include "analysis/quick_return/slotted_arm.h"
#include "analysis/slider_crank.h"

namespace mechwright {

template <class T>
struct SlottedDrivePose {
    SlottedArmPose<T> input;
    SliderCrankPose<T> output;
};

template <class T>
struct SlottedDriveVelocity {
    SlottedArmVelocity<T> input;
    SliderCrankVelocity<T> output;
};

template <class T>
struct SlottedDriveAcceleration {
    SlottedArmAcceleration<T> input;
    SliderCrankAcceleration<T> output;
};

template <class Drive, class T>
SlottedDriveVelocity<T> velocity(const Drive& m, const SlottedDrivePose<T>& p, const T& crank_velocity = T(1)) {
    const auto arm = velocity(input_of(m), p.input, crank_velocity);
    return {arm, velocity(output_of(m), p.output, arm.arm)};
}

template <class Drive, class T>
SlottedDriveAcceleration<T> acceleration(const Drive& m, const SlottedDrivePose<T>& p, const SlottedDriveVelocity<T>& v,
                                         const T& crank_acceleration = T(0)) {
    const auto arm = acceleration(input_of(m), p.input, v.input, crank_acceleration);
    return {arm, acceleration(output_of(m), p.output, v.output, arm.arm)};
}

}  // namespace mechwright
