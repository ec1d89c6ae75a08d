#pragma once
/// \file
/// A slotted arm turned by the block on a crank pin: the input of the crank shaper (crank shorter than the centre
/// distance, the arm swings) and of Whitworth's drive (crank longer, the arm turns fully).
///
/// Arm pivot at the origin, crank pivot at (centre distance, 0); the crank angle is counted from that line of centres,
/// so that at pi the crank points at the arm pivot. With crank and centre distance r and d, and rho the distance from
/// arm pivot to block, rho^2 = (d + r)^2 cos^2(theta/2) + (d - r)^2 sin^2(theta/2); with the difference d - r formed
/// once, nothing cancels however close the two lengths are (derivation: half-angle form of the law of cosines).

#include "analysis/four_bar/pose.h"
#include "analysis/numbers/scalar.h"

namespace mechwright {

template <class T>
struct SlottedArm {
    T centre_distance;  ///< > 0
    T crank;            ///< > 0
};

/// The slot is straight and passes through the arm pivot, so that the block always pushes the arm along the velocity of
/// the point it touches: seen from the arm its pressure angle is zero. Seen from the crank it is the angle between
/// crank and arm, a right angle where the arm turns back.
template <class T>
struct SlottedArmPose {
    Vector<T> crank;  ///< unit vector from crank pivot to crank pin
    Vector<T> arm;    ///< unit vector from arm pivot to block
    T reach;          ///< distance from arm pivot to block
};

template <class T>
SlottedArmPose<T> pose(const SlottedArm<T>& m, const HalfTurn<T>& half) {
    const T difference = m.centre_distance - m.crank;
    const T cc = half.cosine * half.cosine;
    const T ss = half.sine * half.sine;
    SlottedArmPose<T> p;
    p.crank = {cc - ss, T(2) * half.sine * half.cosine};
    p.reach = hypotenuse((m.centre_distance + m.crank) * half.cosine, difference * half.sine);
    p.arm = {(difference + T(2) * m.crank * cc) / p.reach, m.crank * p.crank.y / p.reach};
    return p;
}

/// The angle between the velocity of the crank pin and the push on the arm, in [0, pi/2].
template <class T>
T block_pressure_angle(const SlottedArmPose<T>& p) {
    using std::abs, std::atan2;
    return atan2(abs(cross(p.crank, p.arm)), abs(dot(p.crank, p.arm)));
}

template <class T>
struct SlottedArmVelocity {
    T crank;  ///< angular
    T arm;    ///< angular
    T slide;  ///< of the block along the arm, away from its pivot
};

namespace detail {

/// How the arm angle depends on the crank angle. First derivative r (r + d cos theta) / rho^2, second
/// -d r (d - r)(d + r) sin theta / rho^4.
template <class T>
struct SlottedArmRatio {
    T first;
    T second;
};

template <class T>
SlottedArmRatio<T> ratio(const SlottedArm<T>& m, const SlottedArmPose<T>& p) {
    const T& d = m.centre_distance;
    const T& r = m.crank;
    // r + d cos theta, from the end of the turn that is nearer.
    const T inward = p.crank.x < T(0) ? T((r - d) + d * (p.crank.y * p.crank.y / (T(1) - p.crank.x)))
                                      : T((r + d) - d * (p.crank.y * p.crank.y / (T(1) + p.crank.x)));
    const T square = p.reach * p.reach;
    return {r * inward / square, -(d * r / square) * ((d - r) * (d + r) / square) * p.crank.y};
}

}  // namespace detail

template <class T>
SlottedArmVelocity<T> velocity(const SlottedArm<T>& m, const SlottedArmPose<T>& p, const T& crank_velocity = T(1)) {
    return {crank_velocity, detail::ratio(m, p).first * crank_velocity,
            -(m.centre_distance * p.arm.y) * crank_velocity};
}

template <class T>
struct SlottedArmAcceleration {
    T crank;
    T arm;
    T slide;     ///< of the block along the arm
    T coriolis;  ///< 2 arm velocity x slide velocity, to the left of the arm
};

/// Reference: Theory of Machines, equation (4-19): across the arm, tangential plus Coriolis acceleration of the block
/// are those of the crank pin; along it, slide less normal acceleration.
template <class T>
SlottedArmAcceleration<T> acceleration(const SlottedArm<T>& m, const SlottedArmPose<T>& p,
                                       const SlottedArmVelocity<T>& v, const T& crank_acceleration = T(0)) {
    const auto k = detail::ratio(m, p);
    const Vector<T> pin = m.crank * (crank_acceleration * left_of(p.crank) - (v.crank * v.crank) * p.crank);
    return {crank_acceleration, k.first * crank_acceleration + k.second * v.crank * v.crank,
            dot(p.arm, pin) + p.reach * v.arm * v.arm, T(2) * v.arm * v.slide};
}

}  // namespace mechwright
