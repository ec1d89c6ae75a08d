#pragma once
/// \file
/// Velocities and accelerations of a slider-crank. Reference: Theory of Machines, section 4-4-2 (eccentric
/// slider-crank), re-derived: the loop crank + rod = position along, offset across, differentiated once and twice.

#include "analysis/slider_crank/slider_crank.h"

namespace mechwright {

template <class T>
struct SliderCrankVelocity {
    T crank;  ///< angular
    T rod;    ///< angular; infinite with the rod square to the slide, like that of the ram
    T ram;    ///< along the slide
};

template <class T>
SliderCrankVelocity<T> velocity(const SliderCrank<T>& m, const SliderCrankPose<T>& p, const T& crank_velocity = T(1)) {
    const T pin = m.crank * crank_velocity / p.rod.x;
    return {crank_velocity, -pin * p.crank.x / m.rod, -pin * cross(p.rod, p.crank)};
}

template <class T>
struct SliderCrankAcceleration {
    T crank;
    T rod;
    T ram;
};

template <class T>
SliderCrankAcceleration<T> acceleration(const SliderCrank<T>& m, const SliderCrankPose<T>& p,
                                        const SliderCrankVelocity<T>& v, const T& crank_acceleration = T(0)) {
    const T tangential = m.crank * crank_acceleration;
    const T normal = m.crank * v.crank * v.crank;
    const T rod_normal = m.rod * v.rod * v.rod;
    return {crank_acceleration,
            (rod_normal * p.rod.y + normal * p.crank.y - tangential * p.crank.x) / (m.rod * p.rod.x),
            -(tangential * cross(p.rod, p.crank) + normal * dot(p.rod, p.crank) + rod_normal) / p.rod.x};
}

}  // namespace mechwright
