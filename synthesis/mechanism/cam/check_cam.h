#pragma once
/// \file
/// Checks of a finished cam over the whole turn, in fifty digits.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "synthesis/mechanism/cam/cam_quantities.h"

namespace mechwright::cam {

namespace detail {

inline std::string short_number(const Digits50& number) { return fmt::format("{:.10g}", number.convert_to<double>()); }

/// Whether the dimensions make a cam and a follower at all: triangles close, guides reach the cam.
template <template <class> class F>
Check closes(std::span<const Digits50> d, std::size_t assembly) {
    const auto f = follower_of<F, Digits50>(d, assembly);
    Digits50 margin;
    std::string what;
    if constexpr (std::is_same_v<F<double>, TranslatingRoller<double>>) {
        margin = f.prime_radius - abs(f.offset);
        what = "prime radius less offset";
    } else if constexpr (std::is_same_v<F<double>, OscillatingRoller<double>>) {
        margin = std::min<Digits50>(f.pivot_distance + f.arm_length - f.prime_radius,
                                    f.prime_radius - abs(Digits50(f.pivot_distance - f.arm_length)));
        what = "margin of the triangle of pivot distance, arm and prime radius";
    } else if constexpr (std::is_same_v<F<double>, OscillatingFlat<double>>) {
        margin = std::min<Digits50>(f.pivot_distance - f.base_radius - f.face_offset, f.base_radius + f.face_offset);
        what = "pivot distance less base radius and face offset";
    } else if constexpr (is_contour<F>) {
        const bool nose = f.nose_radius > 0, arc = f.flank_radius > 0;
        margin = nose ? Digits50(f.centre_distance + f.nose_radius - f.base_radius) : f.base_radius;
        if (nose) margin = std::min<Digits50>(margin, f.centre_distance + f.base_radius - f.nose_radius);
        if (arc)
            margin = std::min<Digits50>({margin, f.flank_radius - f.base_radius, f.flank_radius - f.nose_radius,
                                         2 * f.flank_radius - f.base_radius - f.nose_radius - f.centre_distance});
        what = "margin by which the circles of the contour meet";
    } else {
        margin = f.base_radius;
        what = "base radius";
    }
    return {"cam and follower can be assembled", margin >= 0, what + " " + short_number(margin)};
}

/// Whether the cam pushes the follower the way it has to go. A face that swings has to turn against the cam, or there
/// is no envelope, and the contact has to be on the cam's side of the pivot, or the push turns it back.
template <template <class> class F>
Check holds(const Motion& motion, std::span<const Digits50> d) {
    const Digits50 held = -again::over<F, anywhere, again::Released>(motion, d);
    Check check{"the cam holds the follower everywhere", held > 0,
                Layout<F>::roller ? "least cosine of the pressure angle " + short_number(held)
                                  : "least turning of the face against the cam " + short_number(held)};
    if constexpr (Layout<F>::oscillating && !Layout<F>::roller) {
        if (!check.passed) return check;
        const Digits50 lever = -again::over<F, anywhere, again::AlongFace<-1>>(motion, d);
        check.passed = lever > 0;
        check.detail += ", least lever of the contact about the pivot " + short_number(lever);
    }
    return check;
}

/// Whether every part of the cam is there after the roller or face has passed over it.
template <template <class> class F>
Check not_undercut(const Motion& motion, std::span<const Digits50> d, double closed_within) {
    const auto f = follower_of<F, Digits50>(d, motion.assembly);
    const Digits50 margin = again::undercut_margin<F>(motion, d);
    Check check{"the cam is not undercut", margin >= -closed_within, "margin " + short_number(margin)};
    if (check.passed) return check;
    if constexpr (Layout<F>::roller)
        check.detail += ": the roller radius " + short_number(f.roller_radius) + " is larger than " +
                        short_number(f.roller_radius / (1 - margin)) + ", the least radius of the pitch curve";
    else
        check.detail += ": the cam would be hollow by " + short_number(-margin * f.base_radius) +
                        ", which a flat face cannot follow";
    return check;
}

}  // namespace detail

template <template <class> class F>
std::vector<Check> check_cam(const Motion& motion, std::span<const Digits50> d) {
    using detail::short_number;
    std::vector<Check> checks;
    const Digits50 turn = 2 * pi<Digits50>();
    Digits50 greatest_lift = 0, least_angle = turn;
    for (std::size_t i = 0; i < program_of(motion).segments.size(); ++i) {
        greatest_lift = std::max<Digits50>(greatest_lift, abs(d[slots<F>.lift(i)]));
        least_angle = std::min(least_angle, d[slots<F>.angle(i)]);
    }
    constexpr double closed_within = 1e-9;
    const Digits50 open = again::turn<F>(motion, d) - turn, left = again::lift_balance<F>(motion, d);
    checks.push_back(
        {"segments make up a full turn", abs(open) <= closed_within && least_angle > 0,
         least_angle > 0 ? "off by " + short_number(open * 180 / pi<Digits50>()) + " deg" : "a segment has no angle"});
    checks.push_back({"follower returns to where it began", abs(left) <= closed_within * greatest_lift,
                      "off by " + short_number(left)});
    checks.push_back(detail::closes<F>(d, motion.assembly));
    if (!checks.back().passed || !(least_angle > 0)) return checks;
    checks.push_back(detail::holds<F>(motion, d));
    if (!checks.back().passed) return checks;
    checks.push_back(detail::not_undercut<F>(motion, d, closed_within));
    return checks;
}

}  // namespace mechwright::cam
