#pragma once
/// \file
/// The drag-link quick return: a four-bar whose crank and follower both turn fully; an arm on the follower pulls the
/// ram through a rod.
///
/// The four-bar stands in its own frame (crank pivot at the origin, follower pivot at (ground, 0)); the follower is its
/// rocker. The frame of the slide has its origin at the follower pivot and its x axis at slide_angle to the ground
/// link.

#include "analysis/four_bar.h"
#include "analysis/slider_crank.h"

namespace mechwright {

template <class T>
struct DragLink {
    FourBar<T> links;  ///< ground, crank, coupler, follower
    T arm;             ///< follower pivot to rod pin, > 0
    T arm_angle;       ///< from follower to arm
    T rod;             ///< > 0
    T slide_angle;     ///< from the ground link to the slide line
    T slide_offset;    ///< of the slide line from the follower pivot, positive to its left
    Assembly assembly = Assembly::open;
};

template <class To, class From>
DragLink<To> converted(const DragLink<From>& m) {
    return {converted<To>(m.links),
            number_as<To>(m.arm),
            number_as<To>(m.arm_angle),
            number_as<To>(m.rod),
            number_as<To>(m.slide_angle),
            number_as<To>(m.slide_offset),
            m.assembly};
}

template <class T>
SliderCrank<T> output_of(const DragLink<T>& m) {
    return {m.arm, m.rod, m.slide_offset};
}

template <class T>
struct DragLinkPose {
    FourBarPose<T> input;
    SliderCrankPose<T> output;
};

template <class T>
DragLinkPose<T> pose(const DragLink<T>& m, const HalfTurn<T>& half) {
    using std::cos, std::sin;
    const auto links = pose(m.links, half, m.assembly);
    const T turn = m.arm_angle - m.slide_angle;
    return {links, pose(output_of(m), turned(links.rocker, Vector<T>{cos(turn), sin(turn)}))};
}

template <class T>
struct DragLinkVelocity {
    FourBarVelocity<T> input;
    SliderCrankVelocity<T> output;
};

template <class T>
DragLinkVelocity<T> velocity(const DragLink<T>& m, const DragLinkPose<T>& p, const T& crank_velocity = T(1)) {
    const auto links = velocity(m.links, p.input, crank_velocity);
    return {links, velocity(output_of(m), p.output, links.rocker)};
}

template <class T>
struct DragLinkAcceleration {
    FourBarAcceleration<T> input;
    SliderCrankAcceleration<T> output;
};

template <class T>
DragLinkAcceleration<T> acceleration(const DragLink<T>& m, const DragLinkPose<T>& p, const DragLinkVelocity<T>& v,
                                     const T& crank_acceleration = T(0)) {
    const auto links = acceleration(m.links, p.input, v.input, crank_acceleration);
    return {links, acceleration(output_of(m), p.output, v.output, links.rocker)};
}

/// The direction of the crank when the follower stands at an angle to the ground link: the same linkage seen from its
/// other end, where the follower is the crank. Of its two assemblies it is the one in which cross(coupler, crank) has
/// the sign it has in this linkage; in a double crank that sign never changes.
template <class T>
Vector<T> crank_direction_at_follower(const DragLink<T>& m, const T& follower_angle) {
    const FourBar<T> reversed{m.links.ground, m.links.rocker, m.links.coupler, m.links.crank};
    const auto p = pose(converted<double>(m.links), HalfTurn<double>{1, 0}, m.assembly);
    const Assembly assembly = cross(p.crank, p.coupler) > 0 ? Assembly::open : Assembly::crossed;
    return -pose(reversed, half_turn(T(follower_angle - pi<T>())), assembly).rocker;
}

namespace detail {

/// The directions of the crank at the two limits of the ram.
template <class T>
struct LimitCranks {
    RamLimits<T> output;  ///< crank angles of the output slider-crank: those of the arm, to the slide
    Vector<T> outer;
    Vector<T> inner;
};

template <class T>
LimitCranks<T> limit_cranks(const DragLink<T>& m) {
    const auto output = ram_limits(output_of(m));
    const auto crank_at = [&](const T& arm) {
        return crank_direction_at_follower(m, T(arm + m.slide_angle - m.arm_angle));
    };
    return {output, crank_at(output.outer.crank_angle), crank_at(output.inner.crank_angle)};
}

/// The angle from a to b, counter-clockwise, in [0, 2 pi).
template <class T>
T turn_between(const Vector<T>& a, const Vector<T>& b) {
    using std::atan2;
    const T angle = atan2(cross(a, b), dot(a, b));
    return angle < T(0) ? T(angle + T(2) * pi<T>()) : angle;
}

}  // namespace detail

/// Precondition here and below: a double crank (double_crank_margins >= 0) whose arm turns past the slide (rod_margins
/// of output_of >= 0).
template <class T>
Strokes<T> strokes(const DragLink<T>& m) {
    const auto limits = detail::limit_cranks(m);
    return {detail::turn_between(limits.inner, limits.outer), detail::turn_between(limits.outer, limits.inner)};
}

template <class T>
T stroke(const DragLink<T>& m) {
    return stroke(output_of(m));
}

template <class T>
RamLimits<T> ram_limits(const DragLink<T>& m) {
    using std::atan2;
    const auto limits = detail::limit_cranks(m);
    const T outer = atan2(limits.outer.y, limits.outer.x);
    return {{outer, limits.output.outer.position},
            {outer + detail::turn_between(limits.outer, limits.inner), limits.output.inner.position}};
}

}  // namespace mechwright
