#pragma once
/// \file
/// Whitworth's quick return: a crank longer than the centre distance turns a slotted link fully; an arm on the other
/// side of that link's pivot pulls the ram through a rod, on a line through the pivot.
///
/// Angles are counted from the line of centres, from driven pivot to crank pivot, counter-clockwise. The frame of the
/// slide has its origin at the driven pivot and its x axis at slide_angle to the line of centres.

#include "analysis/quick_return/slotted_drive.h"

namespace mechwright {

template <class T>
struct Whitworth {
    T centre_distance;  ///< crank pivot to driven pivot, > 0
    T crank;            ///< > centre_distance
    T arm;              ///< driven pivot to rod pin, opposite the slot, > 0
    T rod;              ///< > arm
    T slide_angle;      ///< from the line of centres to the slide line
};

template <class To, class From>
Whitworth<To> converted(const Whitworth<From>& m) {
    return {number_as<To>(m.centre_distance), number_as<To>(m.crank), number_as<To>(m.arm), number_as<To>(m.rod),
            number_as<To>(m.slide_angle)};
}

template <class T>
SlottedArm<T> input_of(const Whitworth<T>& m) {
    return {m.centre_distance, m.crank};
}

template <class T>
SliderCrank<T> output_of(const Whitworth<T>& m) {
    return {m.arm, m.rod, T(0)};
}

template <class T>
SlottedDrivePose<T> pose(const Whitworth<T>& m, const HalfTurn<T>& half) {
    using std::cos, std::sin;
    const auto slot = pose(input_of(m), half);
    const Vector<T> slide_conjugate{cos(m.slide_angle), -sin(m.slide_angle)};
    return {slot, pose(output_of(m), turned(-slot.arm, slide_conjugate))};
}

/// The crank angle at which the slot stands at an angle to the line of centres. Law of sines in the triangle of the two
/// pivots and the block: centre distance sin(slot) = crank sin(crank angle - slot).
template <class T>
T crank_angle_at_slot(const Whitworth<T>& m, const T& slot) {
    using std::atan2, std::cos, std::sin;
    const T across = m.centre_distance * sin(slot);
    return slot + atan2(across, root_or_zero(T((m.crank - across) * (m.crank + across))));
}

namespace detail {

/// 1 - sin(x), without cancellation near a right angle.
template <class T>
T one_less_sine(const T& x) {
    using std::sin;
    const T half = sin(pi<double>() / 4 - T(0.5) * x);
    return T(2) * half * half;
}

/// crank - sense * centre distance * sin(slide angle), sense +1 or -1, > 0.
template <class T>
T less_projection(const Whitworth<T>& m, double sense) {
    const T signed_angle = T(sense) * m.slide_angle;
    return (m.crank - m.centre_distance) + m.centre_distance * one_less_sine(signed_angle);
}

}  // namespace detail

/// The crank turns through pi +- 2 asin(centre distance sin(slide angle) / crank) between the two positions of the arm
/// on the slide line, the greater angle inwards for a slide angle in (0, pi); as half angles. Reference: Theory of
/// Machines, section 2.5, extended to any slide angle. Precondition here and below: crank >= centre distance, rod >=
/// arm.
template <class T>
Strokes<T> strokes(const Whitworth<T>& m) {
    const auto outward = half_angle_of_squares(detail::less_projection(m, 1), detail::less_projection(m, -1));
    return {T(2) * angle(outward), T(2) * angle(supplement(outward))};
}

/// Twice the arm.
template <class T>
T stroke(const Whitworth<T>& m) {
    return T(2) * m.arm;
}

template <class T>
RamLimits<T> ram_limits(const Whitworth<T>& m) {
    const T outer = crank_angle_at_slot(m, T(m.slide_angle + pi<T>()));
    return {{outer, m.rod + m.arm}, {outer + strokes(m).inward, m.rod - m.arm}};
}

}  // namespace mechwright
