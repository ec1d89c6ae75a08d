#pragma once
/// \file
/// The quantities of a cam with a given follower as rows of the registry.

#include "synthesis/mechanism/cam/measures.h"
#include "synthesis/mechanism/cam/quantities_again.h"

namespace mechwright::cam {

/// A quantity found by a formula over segments of some kinds.
template <template <class> class F, class Formula, Kinds kinds, bool both, Reduce reduce>
Quantity extreme(const char* name, Unit unit, const char* meaning,
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
Quantity dimension_itself(const char* name, Unit unit, const char* meaning) {
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
    return {dimension_itself<F, spring>("spring-rate", Unit::rate, "force of the spring per length"),
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
Quantity jump_quantity(const char* name, Unit unit, const char* meaning) {
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
        again::of_contact<F, again::over<F, in_rises, again::PressureSize>>));
    all.push_back(extreme<F, PressureAngle, in_returns, true, Reduce::greatest>(
        "pressure-angle-return", angle, "greatest size of the pressure angle over the returns",
        again::of_contact<F, again::over<F, in_returns, again::PressureSize>>));
    all.push_back(extreme<F, PressureAngle, anywhere, true, Reduce::greatest>(
        "pressure-angle-max", angle, "greatest size of the pressure angle over the whole turn",
        again::of_contact<F, again::over<F, anywhere, again::PressureSize>>));
    if constexpr (Layout<F>::roller)
        all.push_back(extreme<F, PitchRadius, anywhere, false, Reduce::least>(
            "pitch-radius-min", length, "least convex radius of curvature of the pitch curve", again::pitch_radius<F>));
    all.push_back(extreme<F, ProfileRadius, anywhere, false, Reduce::least>(
        "profile-radius-min", length, "least convex radius of curvature of the cam; negative where it is undercut",
        again::of_contact<F, again::profile_radius<F>>));
    all.push_back(extreme<F, UndercutMargin, anywhere, false, Reduce::least>(
        "undercut-margin", Unit::none,
        Layout<F>::roller ? "1 less the roller radius times the greatest curvature of the pitch curve: 0 is a cusp"
                          : "least radius of curvature of the cam over its base radius: 0 is a cusp",
        again::of_contact<F, again::undercut_margin<F>>));
    if constexpr (!Layout<F>::roller)
        all.push_back({"face-length", length, "length of the face that the contact passes over", Reduce::greatest,
                       dimension_count<F>, has_program, FaceLength<F>::components, FaceLength<F>::measure,
                       again::of_contact<F, again::face_length<F>>});
    all.push_back(extreme<F, ContactDistance, anywhere, false, Reduce::greatest>(
        "cam-size", length, "greatest radius of the cam",
        again::of_contact<F, again::over<F, anywhere, again::Distance>>));
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
            "the follower is held and the cam is not undercut",
            Reduce::least,
            dimension_count<F>,
            has_program,
            ExistenceMargin<F>::components,
            ExistenceMargin<F>::measure};
}

}  // namespace mechwright::cam
