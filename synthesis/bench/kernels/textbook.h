#pragma once
/// \file
/// The kernels as textbooks print them, in plain double: what ours are compared with. Law of cosines with arc cosines,
/// angles carried from formula to formula, differences of squares under roots (Theory of Machines, chapters 4 and 6;
/// Norton, Cam Design and Manufacturing Handbook, chapter 7).

#include <cmath>

#include "analysis/cam/law.h"
#include "analysis/geometry/vector.h"

namespace mechwright::bench::textbook {

/// Angles of a four-bar, open assembly.
struct FourBarAngles {
    double crank, coupler, rocker;
};

inline FourBarAngles four_bar_angles(double ground, double crank, double coupler, double rocker, double angle) {
    const double diagonal = std::sqrt(ground * ground + crank * crank - 2 * ground * crank * std::cos(angle));
    const double at_pivot =
        std::acos((diagonal * diagonal + ground * ground - crank * crank) / (2 * diagonal * ground));
    const double at_rocker =
        std::acos((rocker * rocker + diagonal * diagonal - coupler * coupler) / (2 * rocker * diagonal));
    const double side = std::sin(angle) >= 0 ? 1 : -1;
    const double out = std::acos(-1.0) - side * at_pivot - at_rocker;
    const double x = ground + rocker * std::cos(out) - crank * std::cos(angle);
    const double y = rocker * std::sin(out) - crank * std::sin(angle);
    return {angle, std::atan2(y, x), out};
}

struct CouplerMotion {
    double along, across;  ///< of the point
    double crank;

    Vector<double> position(const FourBarAngles& a) const {
        return {crank * std::cos(a.crank) + along * std::cos(a.coupler) - across * std::sin(a.coupler),
                crank * std::sin(a.crank) + along * std::sin(a.coupler) + across * std::cos(a.coupler)};
    }
    Vector<double> velocity(const FourBarAngles& a, double spin) const {
        return {-crank * std::sin(a.crank) - spin * (along * std::sin(a.coupler) + across * std::cos(a.coupler)),
                crank * std::cos(a.crank) + spin * (along * std::cos(a.coupler) - across * std::sin(a.coupler))};
    }
    Vector<double> acceleration(const FourBarAngles& a, double spin, double turn) const {
        const double x = along * std::cos(a.coupler) - across * std::sin(a.coupler);
        const double y = along * std::sin(a.coupler) + across * std::cos(a.coupler);
        return {-crank * std::cos(a.crank) - spin * spin * x - turn * y,
                -crank * std::sin(a.crank) - spin * spin * y + turn * x};
    }
};

/// Angular velocities of coupler and rocker for unit crank speed.
struct FourBarSpins {
    double coupler, rocker;
};

inline FourBarSpins four_bar_spins(double crank, double coupler, double rocker, const FourBarAngles& a) {
    return {crank / coupler * std::sin(a.rocker - a.crank) / std::sin(a.coupler - a.rocker),
            crank / rocker * std::sin(a.crank - a.coupler) / std::sin(a.rocker - a.coupler)};
}

/// Angular acceleration of the coupler for unit, constant crank speed.
inline double coupler_turn(double crank, double coupler, double rocker, const FourBarAngles& a, const FourBarSpins& w) {
    return (rocker * w.rocker * w.rocker - crank * std::cos(a.crank - a.rocker) -
            coupler * w.coupler * w.coupler * std::cos(a.coupler - a.rocker)) /
           (coupler * std::sin(a.coupler - a.rocker));
}

/// The ram of a slider-crank: position, velocity and acceleration for unit crank speed.
inline double ram_position(double crank, double rod, double offset, double angle) {
    const double height = offset - crank * std::sin(angle);
    return crank * std::cos(angle) + std::sqrt(rod * rod - height * height);
}
inline double rod_slope(double crank, double rod, double offset, double angle) {
    return std::asin((offset - crank * std::sin(angle)) / rod);
}
inline double ram_velocity(double crank, double rod, double offset, double angle) {
    const double slope = rod_slope(crank, rod, offset, angle);
    return -crank * std::sin(angle - slope) / std::cos(slope);
}
inline double ram_acceleration(double crank, double rod, double offset, double angle) {
    const double slope = rod_slope(crank, rod, offset, angle);
    const double spin = -crank * std::cos(angle) / (rod * std::cos(slope));
    return -(crank * std::cos(angle - slope) + rod * spin * spin) / std::cos(slope);
}

/// The angle of a slotted arm to the line of centres, and its first two derivatives by the crank angle.
inline double arm_angle(double centres, double crank, double angle) {
    return std::atan2(crank * std::sin(angle), centres + crank * std::cos(angle));
}
inline double arm_ratio(double centres, double crank, double angle) {
    const double square = centres * centres + crank * crank + 2 * centres * crank * std::cos(angle);
    return crank * (crank + centres * std::cos(angle)) / square;
}
inline double arm_ratio_rate(double centres, double crank, double angle) {
    const double square = centres * centres + crank * crank + 2 * centres * crank * std::cos(angle);
    return centres * crank * (crank * crank - centres * centres) * std::sin(angle) / (square * square);
}

/// Pressure angle and radius of curvature of a translating roller's pitch curve.
inline double pressure_angle(double prime_radius, double offset, const cam::Lift<double>& lift) {
    return std::atan((lift.v - offset) / (lift.s + std::sqrt(prime_radius * prime_radius - offset * offset)));
}
inline double pitch_curvature(double prime_radius, double offset, const cam::Lift<double>& lift) {
    const double r = std::sqrt(prime_radius * prime_radius - offset * offset) + lift.s;
    const double v = lift.v - offset;
    const double speed = std::pow(r * r + v * v, 1.5);
    return (r * r + v * v + v * lift.v - r * lift.a) / speed;
}

}  // namespace mechwright::bench::textbook
