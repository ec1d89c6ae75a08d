#pragma once
/// \file
/// The quantities of a cam with a given follower as rows of the registry.

#include <limits>

#include "synthesis/mechanism/cam/cam_again.h"
#include "synthesis/mechanism/cam/quantities.h"

namespace mechwright::cam {

namespace again {

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
        : c(Layout<F>::contour(motion.program->segments[0].contour, geometry_of<F, Digits50>(d))) {
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
    for (std::size_t i = 0; i < motion.program->segments.size(); ++i)
        sum += d[slots<F>.angle(i)];
    return sum;
}

template <template <class> class F>
Digits50 lift_balance(const Motion& motion, std::span<const Digits50> d) {
    Digits50 sum = 0;
    for (std::size_t i = 0; i < motion.program->segments.size(); ++i)
        sum += lift_sign(motion.program->segments[i].kind) * d[slots<F>.lift(i)];
    return sum;
}

/// The greatest jump of a derivative of the lift where two segments meet.
template <template <class> class F, int order>
Digits50 jump(const Motion& motion, std::span<const Digits50> d) {
    const Rebuilt<F> cam(motion, d);
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

}  // namespace again

/// A quantity found by a formula over segments of some kinds.
template <template <class> class F, class Formula, Kinds kinds, bool both, Reduce reduce>
Quantity extreme(std::string_view name, Unit unit, std::string_view meaning,
                 Digits50 (*measure_again)(const Motion&, std::span<const Digits50>)) {
    using Search = Extremes<F, Formula, kinds, both>;
    return {name,
            unit,
            meaning,
            reduce,
            dimension_count<F>,
            has_segments<kinds>,
            Search::components,
            Search::measure,
            measure_again};
}

template <template <class> class F, std::size_t index>
Quantity dimension_itself(std::string_view name, Unit unit, std::string_view meaning) {
    return {name,
            unit,
            meaning,
            Reduce::only,
            dimension_count<F>,
            has_program,
            one_component,
            measure_dimension<F, index>,
            again::dimension<index>};
}

/// Whether the motion program ends where it began.
template <template <class> class F>
std::array<Quantity, 2> closure() {
    const Unit lift = Layout<F>::oscillating ? Unit::angle : Unit::length;
    return {Quantity{"turn", Unit::angle, "sum of all segment angles", Reduce::only, dimension_count<F>, has_program,
                     one_component, measure_turn<F>, again::turn<F>},
            Quantity{"lift-balance", lift, "all rises less all returns", Reduce::only, dimension_count<F>, has_program,
                     one_component, measure_lift_balance<F>, again::lift_balance<F>}};
}

inline bool has_mass(const Motion& motion) { return has_program(motion) && motion.settings[mass_setting] > 0; }
inline bool has_dynamics(const Motion& motion) { return has_mass(motion) && motion.settings[speed_setting] > 0; }
inline bool has_friction(const Motion& motion) { return has_program(motion) && motion.settings[friction_setting] > 0; }

/// Forces of a follower that a spring holds to the cam; defined where a file says mass and speed.
template <template <class> class F>
std::vector<Quantity> force_quantities() {
    constexpr std::size_t reads = dimension_count<F>;
    using Least = Extremes<F, AxialForce, anywhere, false>;
    using Contact = Extremes<F, ContactForce, anywhere, false>;
    using Torque = Extremes<F, DriveTorque, anywhere, true>;
    using Jump = Extremes<F, JumpSpeed, anywhere, false>;
    constexpr std::size_t spring = Layout<F>::shape;
    return {dimension_itself<F, spring>("spring-rate", Unit::none, "force of the spring per length"),
            dimension_itself<F, spring + 1>("precompression", Unit::length,
                                            "of the spring at the follower's lowest position"),
            {"contact-force-min", Unit::force,
             "least force along the guide that holds the follower to the cam; negative where it leaves the cam",
             Reduce::least, reads, has_dynamics, Least::components, Least::measure, again::least_axial<F>},
            {"contact-force-max", Unit::force, "greatest force between cam and follower, with friction in the guide",
             Reduce::greatest, reads, has_dynamics, Contact::components, Contact::measure, again::greatest_contact<F>},
            {"drive-torque-max", Unit::torque, "greatest size of the torque on the cam", Reduce::greatest, reads,
             has_dynamics, Torque::components, Torque::measure, again::greatest_torque<F>},
            {"jump-speed", Unit::none, "turns per minute at which the follower leaves the cam", Reduce::least, reads,
             has_mass, Jump::components, Jump::measure, again::jump_speed<F>},
            {"jamming-angle", Unit::angle, "pressure angle at which the follower jams in its guide", Reduce::only,
             reads, has_friction, one_component, measure_at_start<F, JammingAngle>, again::jamming<F>}};
}

template <template <class> class F, class Derivative, int order>
Quantity jump_quantity(std::string_view name, Unit unit, std::string_view meaning) {
    Quantity jump{name,
                  unit,
                  meaning,
                  Reduce::greatest,
                  dimension_count<F>,
                  has_program,
                  Jumps<F, Derivative>::components,
                  Jumps<F, Derivative>::measure,
                  again::jump<F, order>};
    jump.paired = true;
    return jump;
}

template <template <class> class F>
std::vector<Quantity> cam_quantities() {
    const Unit lift = Layout<F>::oscillating ? Unit::angle : Unit::length;
    const Unit angle = Unit::angle, length = Unit::length;
    std::vector<Quantity> all;
    constexpr bool contour = is_contour<F>;
    if constexpr (contour) {
        all.push_back(dimension_itself<F, 0>("base-radius", length, "least radius of the cam"));
        all.push_back({"lift", length, "way of the follower", Reduce::only, dimension_count<F>, has_contour,
                       one_component, measure_contour<F, WholeLift>, again::whole_lift<F>});
        all.push_back({"action-angle", angle, "cam angle between the ends of the base circle", Reduce::only,
                       dimension_count<F>, has_flanks, one_component, measure_contour<F, ActionAngle>,
                       again::action_angle<F>});
        all.push_back({"flank-angle", angle, "cam angle at which the contact passes from flank to nose", Reduce::only,
                       dimension_count<F>, has_flanks, one_component, measure_contour<F, FlankAngle>,
                       again::angle_of_flank<F>});
    } else if constexpr (Layout<F>::roller) {
        all.push_back(dimension_itself<F, 0>("prime-radius", length, "least radius of the pitch curve"));
        if constexpr (Layout<F>::oscillating)
            all.push_back(
                dimension_itself<F, 1>("pivot-distance", length, "distance of the arm's pivot from the cam centre"));
        else
            all.push_back(dimension_itself<F, 1>("offset", length, "distance of the guide from the cam centre"));
    } else {
        all.push_back(dimension_itself<F, 0>("base-radius", length, "least radius of the cam"));
        if constexpr (Layout<F>::oscillating)
            all.push_back(
                dimension_itself<F, 1>("pivot-distance", length, "distance of the face's pivot from the cam centre"));
    }
    if constexpr (Layout<F>::oscillating)
        all.push_back({"start-angle", angle, "angle of the arm or face to the line of centres at the lowest position",
                       Reduce::only, dimension_count<F>, has_program, one_component, measure_at_start<F, StartAngle>,
                       again::start_angle<F>});
    all.push_back(extreme<F, PressureAngle, in_rises, true, Reduce::greatest>(
        "pressure-angle-rise", angle, "greatest size of the pressure angle over the rises",
        again::over<F, in_rises, again::PressureSize>));
    all.push_back(extreme<F, PressureAngle, in_returns, true, Reduce::greatest>(
        "pressure-angle-return", angle, "greatest size of the pressure angle over the returns",
        again::over<F, in_returns, again::PressureSize>));
    all.push_back(extreme<F, PressureAngle, anywhere, true, Reduce::greatest>(
        "pressure-angle-max", angle, "greatest size of the pressure angle over the whole turn",
        again::over<F, anywhere, again::PressureSize>));
    if constexpr (Layout<F>::roller)
        all.push_back(extreme<F, PitchRadius, anywhere, false, Reduce::least>(
            "pitch-radius-min", length, "least convex radius of curvature of the pitch curve", again::pitch_radius<F>));
    all.push_back(extreme<F, ProfileRadius, anywhere, false, Reduce::least>(
        "profile-radius-min", length, "least convex radius of curvature of the cam; negative where it is undercut",
        again::profile_radius<F>));
    all.push_back(extreme<F, UndercutMargin, anywhere, false, Reduce::least>(
        "undercut-margin", Unit::none,
        Layout<F>::roller ? "1 less the roller radius times the greatest curvature of the pitch curve: 0 is a cusp"
                          : "least radius of curvature of the cam over its base radius: 0 is a cusp",
        again::undercut_margin<F>));
    if constexpr (!Layout<F>::roller)
        all.push_back({"face-length", length, "length of the face that the contact passes over", Reduce::greatest,
                       dimension_count<F>, has_program, FaceLength<F>::components, FaceLength<F>::measure,
                       again::face_length<F>});
    all.push_back(extreme<F, ContactDistance, anywhere, false, Reduce::greatest>(
        "cam-size", length, "greatest radius of the cam", again::over<F, anywhere, again::Distance>));
    all.push_back(extreme<F, Velocity, anywhere, true, Reduce::greatest>(
        "velocity-max", lift, "greatest velocity of the follower, for unit angular velocity of the cam",
        again::over<F, anywhere, again::LiftDerivative<1>>));
    all.push_back(extreme<F, Acceleration, anywhere, true, Reduce::greatest>(
        "acceleration-max", lift,
        "greatest acceleration of the follower, for unit angular velocity of the cam; jumps of the velocity not "
        "counted",
        again::over<F, anywhere, again::LiftDerivative<2>>));
    all.push_back(extreme<F, Jerk, anywhere, true, Reduce::greatest>(
        "jerk-max", lift,
        "greatest jerk of the follower, for unit angular velocity of the cam; jumps of the acceleration not counted",
        again::over<F, anywhere, again::LiftDerivative<3>>));
    all.push_back(
        jump_quantity<F, Velocity, 1>("velocity-jump", lift, "greatest jump of the velocity where segments meet"));
    all.push_back(jump_quantity<F, Acceleration, 2>("acceleration-jump", lift,
                                                    "greatest jump of the acceleration where segments meet"));
    all.push_back(jump_quantity<F, Jerk, 3>("jerk-jump", lift, "greatest jump of the jerk where segments meet"));
    if constexpr (Layout<F>::geometry > Layout<F>::shape)
        for (const Quantity& quantity : force_quantities<F>())
            all.push_back(quantity);
    for (const Quantity& quantity : closure<F>())
        all.push_back(quantity);
    return all;
}

template <template <class> class F>
Quantity existence_margin() {
    return {"existence margin",
            Unit::length,
            "what the cam can be changed by before it is none",
            Reduce::least,
            dimension_count<F>,
            has_program,
            ExistenceMargin<F>::components,
            ExistenceMargin<F>::measure};
}

}  // namespace mechwright::cam
