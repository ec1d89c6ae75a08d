#pragma once
/// \file
/// The measures of a cam for verification, each made of what `cam_again.h` finds of its positions.

#include "synthesis/mechanism/cam/cam_again.h"

namespace mechwright::cam::again {

/// Measures of a place for `greatest`, by name of what they find.
struct PressureSize {
    template <class R, template <class> class F>
    R operator()(const F<R>& f, const Here<R>& here) const {
        using std::abs;
        return abs(cam_here(f, here).pressure_angle);
    }
};
struct Curvature {
    template <class R, template <class> class F>
    R operator()(const F<R>& f, const Here<R>& here) const {
        return cam_here(f, here).curvature;
    }
};
/// The negative radius under a face, which may be hollow.
struct RadiusDeficit {
    template <class R, template <class> class F>
    R operator()(const F<R>& f, const Here<R>& here) const {
        return -1 / cam_here(f, here).curvature;
    }
};
struct Distance {
    template <class R, template <class> class F>
    R operator()(const F<R>& f, const Here<R>& here) const {
        using std::sqrt;
        const auto p = cam_here(f, here).contact;
        return sqrt(R(dot(p, p)));
    }
};
template <int sign>
struct AlongFace {
    template <class R, template <class> class F>
    R operator()(const F<R>& f, const Here<R>& here) const {
        return sign * cam_here(f, here).along;
    }
};
struct Released {
    template <class R, template <class> class F>
    R operator()(const F<R>& f, const Here<R>& here) const {
        return -cam_here(f, here).held;
    }
};
template <int order>
struct LiftDerivative {
    template <class R>
    static R of(const Here<R>& here) {
        const auto lift = [&](const R& t) { return here.lift(t); };
        if constexpr (order == 3)
            return third_derivative<R>(lift);
        else
            return order == 1 ? derivatives<R>(lift).first : derivatives<R>(lift).second;
    }
    template <class R, template <class> class F>
    R operator()(const F<R>&, const Here<R>& here) const {
        using std::abs;
        return abs(of(here));
    }
};

template <template <class> class F, Kinds kinds, class Measure>
Digits50 over(const Motion& motion, std::span<const Digits50> d) {
    return greatest(Rebuilt<F>(motion, d), kinds, Measure{});
}

/// What is measured of the contact, which an oscillating face that does not turn against the cam has not.
template <template <class> class F, Digits50 (*measure)(const Motion&, std::span<const Digits50>)>
Digits50 of_contact(const Motion& motion, std::span<const Digits50> d) {
    if constexpr (Layout<F>::oscillating && !Layout<F>::roller)
        if (!(over<F, anywhere, Released>(motion, d) < 0)) return std::numeric_limits<Digits50>::quiet_NaN();
    return measure(motion, d);
}

/// Forces, from the same differences: what presses on the cam along the guide.
template <class R>
R axial(const FollowerLoad<Digits50>& l, const Here<R>& here) {
    const auto lift = derivatives<R>([&](const R& t) { return here.lift(t); });
    return R(l.weight + l.load + l.spring_rate * l.precompression) + R(l.spring_rate) * lift.value +
           R(l.mass * l.speed * l.speed) * lift.second;
}

template <class R>
R closing(const FollowerLoad<Digits50>& l, const Here<R>& here) {
    return R(l.weight + l.load + l.spring_rate * l.precompression) + R(l.spring_rate) * here.lift(R(0));
}

template <class R, template <class> class F>
R contact(const FollowerLoad<Digits50>& l, const F<R>& f, const Here<R>& here) {
    using std::abs, std::cos, std::sin;
    const R angle = cam_here(f, here).pressure_angle;
    const R b(l.guide_length), friction(l.friction);
    if (!(l.friction > 0) || !(b > 0)) return axial(l, here) / cos(angle);
    // Moments about the two edges of the guide: F b = N (b cos phi - f (2 a + b - f D) |sin phi|).
    return axial(l, here) * b /
           (b * cos(angle) - friction * (2 * R(l.overhang) + b - friction * R(l.stem_diameter)) * abs(R(sin(angle))));
}

template <template <class> class F>
FollowerLoad<Digits50> load(const Motion& motion, std::span<const Digits50> d) {
    return load_of<F>(geometry_of<F, Digits50>(d), motion);
}

template <template <class> class F>
Digits50 least_axial(const Motion& motion, std::span<const Digits50> d) {
    const auto l = load<F>(motion, d);
    return -greatest(Rebuilt<F>(motion, d), anywhere,
                     [&]<class R>(const F<R>&, const Here<R>& here) { return R(-axial(l, here)); });
}

template <template <class> class F>
Digits50 greatest_contact(const Motion& motion, std::span<const Digits50> d) {
    const auto l = load<F>(motion, d);
    return greatest(Rebuilt<F>(motion, d), anywhere,
                    [&]<class R>(const F<R>& f, const Here<R>& here) { return contact(l, f, here); });
}

/// Force times the lever arm of the contact normal about the axis.
template <template <class> class F>
Digits50 greatest_torque(const Motion& motion, std::span<const Digits50> d) {
    const auto l = load<F>(motion, d);
    return greatest(Rebuilt<F>(motion, d), anywhere, [&]<class R>(const F<R>& f, const Here<R>& here) {
        using std::abs, std::cos;
        const auto lift = derivatives<R>([&](const R& t) { return here.lift(t); });
        return R(abs(R(contact(l, f, here) * lift.first * cos(cam_here(f, here).pressure_angle))));
    });
}

template <template <class> class F>
Digits50 jump_speed(const Motion& motion, std::span<const Digits50> d) {
    const auto l = load<F>(motion, d);
    const Digits50 tendency = greatest(Rebuilt<F>(motion, d), anywhere, [&]<class R>(const F<R>&, const Here<R>& here) {
        return R(-R(l.mass) * derivatives<R>([&](const R& t) { return here.lift(t); }).second / closing(l, here));
    });
    return 30 / pi<Digits50>() / sqrt(std::max<Digits50>(tendency, 1e-12));
}

template <template <class> class F>
Digits50 jamming(const Motion& motion, std::span<const Digits50> d) {
    const auto l = load<F>(motion, d);
    return atan2(l.guide_length,
                 Digits50(l.friction) * (2 * l.overhang + l.guide_length - Digits50(l.friction) * l.stem_diameter));
}

template <template <class> class F>
Digits50 pitch_radius(const Motion& motion, std::span<const Digits50> d) {
    return 1 / over<F, anywhere, Curvature>(motion, d);
}

template <template <class> class F>
Digits50 profile_radius(const Motion& motion, std::span<const Digits50> d) {
    if constexpr (Layout<F>::roller)
        return pitch_radius<F>(motion, d) - follower_of<F, Digits50>(d, motion.assembly).roller_radius;
    else
        return -over<F, anywhere, RadiusDeficit>(motion, d);
}

template <template <class> class F>
Digits50 undercut_margin(const Motion& motion, std::span<const Digits50> d) {
    const auto follower = follower_of<F, Digits50>(d, motion.assembly);
    if constexpr (Layout<F>::roller)
        return 1 - follower.roller_radius * over<F, anywhere, Curvature>(motion, d);
    else
        return profile_radius<F>(motion, d) / follower.base_radius;
}

template <template <class> class F>
Digits50 start_angle(const Motion& motion, std::span<const Digits50> d) {
    const auto f = follower_of<F, Digits50>(d, motion.assembly);
    if constexpr (Layout<F>::roller)
        return acos(
            (f.pivot_distance * f.pivot_distance + f.arm_length * f.arm_length - f.prime_radius * f.prime_radius) /
            (2 * f.pivot_distance * f.arm_length));
    else
        return asin((f.base_radius + f.face_offset) / f.pivot_distance);
}

/// The contour rebuilt as the definition has it: the lift by the distances along the nose, the angles by the triangle
/// of the circles' centres and the common normal.
template <template <class> class F>
struct ContourAgain {
    Contour<Digits50> c;
    Digits50 rise, flank;

    ContourAgain(const Motion& motion, std::span<const Digits50> d)
        : c(Layout<F>::contour(program_of(motion).segments[0].contour, geometry_of<F, Digits50>(d))) {
        const Digits50& distance = c.centre_distance;
        if (c.kind == ContourKind::tangent) {
            // The flank is the common tangent of base and nose circles.
            rise = asin(sqrt(distance * distance - (c.base_radius - c.nose_radius) * (c.base_radius - c.nose_radius)) /
                        distance);
            if (c.nose_radius > c.base_radius) rise = pi<Digits50>() - rise;
            flank = atan(distance * sin(rise) / (c.base_radius + c.roller_radius));
            return;
        }
        if (c.kind != ContourKind::circular_arc) return;
        const Digits50 a = c.flank_radius - c.base_radius, b = c.flank_radius - c.nose_radius;
        // Half-angle formula of the triangle with sides a, distance, b; the rise is what its angle lacks of pi.
        const Digits50 s = (a + distance + b) / 2;
        rise = pi<Digits50>() - 2 * atan2(sqrt((s - a) * (s - distance)), sqrt(s * (s - b)));
        const Digits50 at_flank = asin(distance * sin(rise) / b);
        if (!c.roller) {
            flank = at_flank;
            return;
        }
        const Digits50 reach = c.flank_radius + c.roller_radius;
        flank = atan2(reach * sin(at_flank), reach * cos(at_flank) - a);
    }
};

template <template <class> class F>
Digits50 whole_lift(const Motion& motion, std::span<const Digits50> d) {
    const auto c = ContourAgain<F>(motion, d).c;
    return c.kind == ContourKind::eccentric ? Digits50(2 * c.centre_distance)
                                            : Digits50(c.nose_radius + c.centre_distance - c.base_radius);
}

template <template <class> class F>
Digits50 action_angle(const Motion& motion, std::span<const Digits50> d) {
    return 2 * ContourAgain<F>(motion, d).rise;
}

template <template <class> class F>
Digits50 angle_of_flank(const Motion& motion, std::span<const Digits50> d) {
    return ContourAgain<F>(motion, d).flank;
}

template <template <class> class F>
Digits50 face_length(const Motion& motion, std::span<const Digits50> d) {
    return over<F, anywhere, AlongFace<1>>(motion, d) + over<F, anywhere, AlongFace<-1>>(motion, d);
}

template <std::size_t index>
Digits50 dimension(const Motion&, std::span<const Digits50> d) {
    return d[index];
}

template <template <class> class F>
Digits50 turn(const Motion& motion, std::span<const Digits50> d) {
    Digits50 sum = 0;
    for (std::size_t i = 0; i < program_of(motion).segments.size(); ++i)
        sum += d[slots<F>.angle(i)];
    return sum;
}

template <template <class> class F>
Digits50 lift_balance(const Motion& motion, std::span<const Digits50> d) {
    Digits50 sum = 0;
    for (std::size_t i = 0; i < program_of(motion).segments.size(); ++i)
        sum += lift_sign(program_of(motion).segments[i].kind) * d[slots<F>.lift(i)];
    return sum;
}

/// The greatest jump of a derivative of the lift where two segments meet.
template <template <class> class F, int order>
Digits50 jump(const Motion& motion, std::span<const Digits50> d) {
    const RebuiltMotion cam = Rebuilt<F>(motion, d).motion;
    Digits50 greatest = 0;
    const std::size_t n = cam.segments.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = i + 1 == n ? 0 : i + 1, last = pieces(cam.segments[i]) - 1;
        const auto before = cam.here(i, last, break_before(cam.segments[i], last + 1));
        const auto after = cam.here(next, 0, break_before(cam.segments[next], 0));
        greatest =
            std::max<Digits50>(greatest, abs(LiftDerivative<order>::of(after) - LiftDerivative<order>::of(before)));
    }
    return greatest;
}

}  // namespace mechwright::cam::again
