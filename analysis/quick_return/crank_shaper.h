#pragma once
/// \file
/// The crank shaper (crank and slotted lever): a crank shorter than the centre distance swings a slotted lever, whose
/// end pulls the ram through a rod. The ram line is square to the line of centres.
///
/// Angles are counted from the line of centres, from lever pivot to crank pivot, counter-clockwise. The frame of the
/// slide has its x axis along the ram line, a right angle to the left of the line of centres, and its origin at the
/// lever pivot; in it the lever and the rod are a slider-crank of offset -ram_distance whose crank swings.

#include "analysis/quick_return/slotted_drive.h"

namespace mechwright {

template <class T>
struct CrankShaper {
    T centre_distance;  ///< crank pivot to lever pivot, > crank
    T crank;            ///< > 0
    T lever;            ///< lever pivot to rod pin, > 0
    T rod;              ///< > 0
    T ram_distance;     ///< lever pivot to ram line, towards the crank pivot
};

template <class To, class From>
CrankShaper<To> converted(const CrankShaper<From>& m) {
    return {number_as<To>(m.centre_distance), number_as<To>(m.crank), number_as<To>(m.lever), number_as<To>(m.rod),
            number_as<To>(m.ram_distance)};
}

template <class T>
SlottedArm<T> input_of(const CrankShaper<T>& m) {
    return {m.centre_distance, m.crank};
}

template <class T>
SliderCrank<T> output_of(const CrankShaper<T>& m) {
    return {m.lever, m.rod, -m.ram_distance};
}

template <class T>
SlottedDrivePose<T> pose(const CrankShaper<T>& m, const HalfTurn<T>& half) {
    const auto lever = pose(input_of(m), half);
    return {lever, pose(output_of(m), Vector<T>{lever.arm.y, -lever.arm.x})};
}

/// The greatest angle between lever and line of centres has the sine crank / centre distance; this is that unit vector
/// (cosine, sine).
template <class T>
Vector<T> greatest_lever_swing(const CrankShaper<T>& m) {
    const T leg = root_or_zero(T((m.centre_distance - m.crank) * (m.centre_distance + m.crank)));
    return {leg / m.centre_distance, m.crank / m.centre_distance};
}

/// What a crank shaper needs to work as one, every component >= 0: the lever swings; the rod reaches the ram line with
/// the lever upright and at the ends of its swing; and lever and rod do not fall into line within the swing, where the
/// ram would turn back. On the way from one end to the other the two can be in line at most once, so that the ends
/// tell.
template <class T>
struct CrankShaperMargins {
    T swings;           ///< centre distance - crank
    T reaches_upright;  ///< rod + ram distance - lever
    T reaches_ends;     ///< rod - ram distance + distance of the rod pin along the line of centres
    T pulls_at_outer;   ///< moment arm of the rod about the lever pivot at the outer end of the swing
    T pulls_at_inner;   ///< and at the inner end
};

template <class T>
CrankShaperMargins<T> margins(const CrankShaper<T>& m) {
    const Vector<T> end = greatest_lever_swing(m);
    const auto moment_arm = [&](const T& sine) {
        const auto p = pose(output_of(m), Vector<T>{sine, -end.x});
        return m.lever * cross(p.crank, p.rod);
    };
    return {m.centre_distance - m.crank, sum_difference(m.rod, m.ram_distance, m.lever, T(0)),
            m.rod - m.ram_distance + m.lever * end.x, moment_arm(end.y), moment_arm(-end.y)};
}

/// The strokes: outward while the lever swings to the left of the line of centres, always the slow one. Reference:
/// Theory of Machines, section 2.5: the lever turns back where the crank is square to it, at crank angles with the
/// cosine -crank / centre distance; written as a half angle, which keeps its digits next to crank = centre distance.
/// Precondition here and below: all margins >= 0.
template <class T>
Strokes<T> strokes(const CrankShaper<T>& m) {
    const auto inward = half_angle_of_squares(T(m.centre_distance - m.crank), T(m.centre_distance + m.crank));
    return {T(2) * angle(supplement(inward)), T(2) * angle(inward)};
}

/// 2 lever crank / centre distance: both ends of the swing lie at the same distance from the ram line.
template <class T>
T stroke(const CrankShaper<T>& m) {
    return T(2) * m.lever * m.crank / m.centre_distance;
}

template <class T>
RamLimits<T> ram_limits(const CrankShaper<T>& m) {
    const Vector<T> end = greatest_lever_swing(m);
    const T half_outward = T(0.5) * strokes(m).outward;
    const auto at = [&](const T& sine) { return pose(output_of(m), Vector<T>{sine, -end.x}).position; };
    return {{half_outward, at(end.y)}, {T(2) * pi<T>() - half_outward, at(-end.y)}};
}

}  // namespace mechwright
