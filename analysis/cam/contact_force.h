#pragma once
/// \file
/// Forces on a translating follower that a spring holds to its cam. Units are those of the problem taken together:
/// force = mass times length over time squared (millimetres, newtons and seconds go with tonnes). Lift derivatives are
/// with respect to the cam angle.

#include <cmath>

#include "analysis/cam/law.h"

namespace mechwright::cam {

/// What presses the follower onto the cam, and how it is guided.
template <class T>
struct FollowerLoad {
    T spring_rate;
    T precompression;  ///< of the spring, at the lowest position: a length
    T load;            ///< any other force towards the cam
    T weight;          ///< as far as it acts towards the cam
    T guide_length;
    T overhang;       ///< of the roller centre over the near edge of the guide, at the lowest position
    T stem_diameter;  ///< of the follower in its guide
    double mass = 0;
    double speed = 0;     ///< of the cam, radians per second
    double friction = 0;  ///< coefficient, in the guide
};

/// Spring, load and weight together.
template <class T>
T closing_force(const FollowerLoad<T>& l, const Lift<T>& lift) {
    return l.weight + l.load + l.spring_rate * (l.precompression + lift.s);
}

/// Force along the guide that the cam must exert; negative where the follower leaves the cam.
template <class T>
T axial_force(const FollowerLoad<T>& l, const Lift<T>& lift) {
    return closing_force(l, lift) + T(Constant<T>(l.mass * l.speed * l.speed)) * lift.a;
}

/// What the axial force is divided by to give the force between cam and roller, cosine and sine of the pressure angle
/// given: less than the cosine by the friction of two edges of the guide. Not positive: the follower jams.
/// (b cos phi - f (2 a + b - f D) |sin phi|) / b with overhang a, guide length b, stem diameter D.
template <class T>
T effective_cosine(const FollowerLoad<T>& l, const T& cosine, const T& sine) {
    using std::abs;
    if (!(l.friction > 0) || !(l.guide_length > T())) return cosine;
    const T f(Constant<T>(l.friction));
    const T arm = T(Constant<T>(2)) * l.overhang + l.guide_length - f * l.stem_diameter;
    return cosine - f * arm / l.guide_length * abs(sine);
}

/// Pressure angle at which the follower jams in its guide.
template <class T>
T jamming_angle(const FollowerLoad<T>& l) {
    using std::atan2;
    const T f(Constant<T>(l.friction));
    return atan2(l.guide_length, f * (T(Constant<T>(2)) * l.overhang + l.guide_length - f * l.stem_diameter));
}

/// mass * |acceleration| over the closing force, for a cam turning at one radian per second: the follower leaves the
/// cam at the speed whose square is one over its greatest value. Negative where the follower is accelerated from the
/// cam.
template <class T>
T lifting_tendency(const FollowerLoad<T>& l, const Lift<T>& lift) {
    return -T(Constant<T>(l.mass)) * lift.a / closing_force(l, lift);
}

}  // namespace mechwright::cam
