#pragma once
/// \file
/// Cams measured a second time, for verification: from positions of the follower alone, in fifty digits. Tangents,
/// curvatures, velocities are differences of positions; normals and pressure angles follow from the tangent. No formula
/// of the analysis but the law's own lift is used.

#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "analysis/numbers/unit_vector.h"
#include "synthesis/mechanism/cam/layout.h"

namespace mechwright::cam::again {

/// Steps of the difference formulas: far above rounding, far below what the motion does.
template <class R>
struct Step;
template <>
struct Step<double> {
    static constexpr double first = 1e-3, third = 1e-2;
};
template <>
struct Step<Digits50> {
    static constexpr double first = 1e-9, third = 1e-7;
};

template <class R>
struct Derivatives {
    R value, first, second;
};

/// A value and first two derivatives at 0 by differences, from values at -2, -1, 0, 1 and 2 steps.
template <class R>
Derivatives<R> derivatives(const std::array<R, 5>& f) {
    const R h(Step<R>::first);
    return {f[2], (f[0] - 8 * f[1] + 8 * f[3] - f[4]) / (12 * h),
            (-f[0] + 16 * f[1] - 30 * f[2] + 16 * f[3] - f[4]) / (12 * h * h)};
}

/// The values of a function at those steps.
template <class R, class Function>
auto five_values(const Function& f) {
    const R h(Step<R>::first);
    return std::array{f(R(-2 * h)), f(R(-h)), f(R(0)), f(h), f(R(2 * h))};
}

template <class R, class Function>
Derivatives<R> derivatives(const Function& f) {
    return derivatives<R>(five_values<R>(f));
}

/// Of two coordinates of what a function gives.
template <class R, class Function, class First, class Second>
std::array<Derivatives<R>, 2> derivatives_of_two(const Function& f, First first, Second second) {
    const auto values = five_values<R>(f);
    std::array<R, 5> a, b;
    for (std::size_t i = 0; i < values.size(); ++i) {
        a[i] = values[i].*first;
        b[i] = values[i].*second;
    }
    return {derivatives<R>(a), derivatives<R>(b)};
}

template <class R, class Function>
R third_derivative(const Function& f) {
    const R h(Step<R>::third);
    const auto odd = [&](int k) { return R(f(R(k * h)) - f(R(-k * h))); };
    return (-13 * odd(1) + 8 * odd(2) - odd(3)) / (8 * h * h * h);
}

/// A segment at a place, to be moved by small cam angles.
template <class R>
struct Here {
    const Segment<R>* segment;
    R start_lift;
    std::size_t piece;
    R u;

    R lift(const R& cam_angle) const {
        return lift_at(*segment, piece, R(u + cam_angle / angle_per_part(*segment, piece)), start_lift).s;
    }
};

/// A vector of the fixed plane as the cam sees it after turning by a small angle.
template <class R>
Vector<R> seen_by_cam(const Vector<R>& v, int sense, const R& cam_angle) {
    return turned(v, unit_at(R(-sense * cam_angle)));
}

/// Centre of the roller and direction of its rise, in the fixed plane.
template <class R>
struct Centre {
    Vector<R> position;
    Vector<R> rise;
};

template <class R>
Centre<R> centre(const TranslatingRoller<R>& f, const R& lift) {
    using std::sqrt;
    return {{f.sense * f.offset, R(sqrt(R(f.prime_radius * f.prime_radius - f.offset * f.offset)) + lift)},
            {R(0), R(1)}};
}

template <class R>
Centre<R> centre(const ContourRoller<R>& f, const R& lift) {
    return {{R(0), f.base_radius + f.roller_radius + lift}, {R(0), R(1)}};
}

template <class R>
Centre<R> centre(const OscillatingRoller<R>& f, const R& lift) {
    using std::acos, std::cos, std::sin;
    const R& c = f.pivot_distance;
    const R& l = f.arm_length;
    const R arm = acos(R((c * c + l * l - f.prime_radius * f.prime_radius) / (2 * c * l))) + lift;
    return {{R(c - l * cos(arm)), R(l * sin(arm))}, {sin(arm), cos(arm)}};
}

/// Distance of the face from the cam centre and direction of its normal, in the fixed plane.
template <class R>
struct Face {
    R distance;
    R direction;
    R foot;  ///< place of the cam centre's foot along the face, from guide or pivot's foot
};

template <class R>
Face<R> face(const TranslatingFlat<R>& f, const R& lift) {
    return {f.base_radius + lift, pi<R>() / 2, R(0)};
}

template <class R>
Face<R> face(const ContourFlat<R>& f, const R& lift) {
    return {f.base_radius + lift, pi<R>() / 2, R(0)};
}

template <class R>
Face<R> face(const OscillatingFlat<R>& f, const R& lift) {
    using std::asin, std::cos, std::sin;
    const R angle = asin(R((f.base_radius + f.face_offset) / f.pivot_distance)) + lift;
    return {f.pivot_distance * sin(angle) - f.face_offset, pi<R>() / 2 - angle, f.pivot_distance * cos(angle)};
}

/// What the cam is like at a place.
template <class R>
struct CamHere {
    Vector<R> contact;  ///< in the fixed plane
    R pressure_angle;
    R held;       ///< cosine of the pressure angle; under a face how fast it turns against the cam
    R curvature;  ///< of the pitch curve; under a face of the cam
    R along;      ///< the face
};

template <class R, template <class> class Follower>
CamHere<R> cam_here(const Follower<R>& f, const Here<R>& here) {
    using std::atan2, std::hypot, std::sqrt;
    if constexpr (Layout<Follower>::roller) {
        const auto pitch = [&](const R& t) { return seen_by_cam(centre(f, here.lift(t)).position, f.sense, t); };
        const auto [x, y] = derivatives_of_two<R>(pitch, &Vector<R>::x, &Vector<R>::y);
        const R speed = sqrt(R(x.first * x.first + y.first * y.first));
        const Vector<R> tangent{R(x.first / speed), R(y.first / speed)};
        // Clockwise round a cam that turns counter-clockwise: the outside is on the left.
        const Vector<R> normal = R(f.sense) * left_of(tangent);
        const Vector<R> rise = centre(f, here.lift(R(0))).rise;
        const R straight = dot(normal, rise), aside = -f.sense * cross(normal, rise);
        return {Vector<R>{x.value, y.value} - f.roller_radius * normal, R(atan2(aside, straight)), straight,
                R(-f.sense * (x.first * y.second - y.first * x.second) / (speed * speed * speed)), R(0)};
    } else {
        // The face as a line of the cam: distance p of the centre and direction of the normal a. The contact lies at
        // dp/da along the line, the radius of curvature is p + d2p/da2.
        const auto seen = [&](const R& t) {
            Face<R> line = face(f, here.lift(t));
            line.direction -= f.sense * t;
            return line;
        };
        const auto [p, a] = derivatives_of_two<R>(seen, &Face<R>::distance, &Face<R>::direction);
        const R slope = p.first / a.first;
        const R radius = p.value + (p.second - slope * a.second) / (a.first * a.first);
        const Face<R> now = face(f, here.lift(R(0)));
        const Vector<R> normal = unit_at(now.direction);
        const R along = Layout<Follower>::oscillating ? R(now.foot + slope) : R(-slope);
        R angle(0);
        if constexpr (Layout<Follower>::oscillating) angle = atan2(f.face_offset, along);
        return {p.value * normal + slope * left_of(normal), angle, R(-f.sense * a.first), R(1 / radius),
                Layout<Follower>::oscillating ? along : R(f.sense * along)};
    }
}

/// The segments of a cam, in double to look for places and in fifty digits to measure there.
struct RebuiltMotion {
    std::vector<Segment<Digits50>> segments{};
    std::vector<Segment<double>> plain_segments{};
    std::vector<Digits50> start_lifts{};

    Here<Digits50> here(std::size_t segment, std::size_t piece, const Digits50& u) const {
        return {&segments[segment], start_lifts[segment], piece, u};
    }
    Here<double> roughly(std::size_t segment, std::size_t piece, double u) const {
        return {&plain_segments[segment], start_lifts[segment].convert_to<double>(), piece, u};
    }
};

/// A cam rebuilt from its dimensions, with its follower in both kinds of numbers.
template <template <class> class Follower>
struct Rebuilt {
    Follower<Digits50> follower;
    Follower<double> plain_follower;
    RebuiltMotion motion;

    Rebuilt(const Motion& m, std::span<const Digits50> dimensions) {
        std::vector<double> plain;
        for (const Digits50& d : dimensions)
            plain.push_back(d.convert_to<double>());
        const std::span<const double> rounded(plain);
        follower = follower_of<Follower, Digits50>(dimensions, m.assembly);
        plain_follower = follower_of<Follower, double>(rounded, m.assembly);
        for (std::size_t i = 0; i < program_of(m).segments.size(); ++i) {
            const auto p = parameters_of<Digits50>(program_of(m), slots<Follower>, dimensions, i);
            motion.segments.push_back(with_contour<Follower>(segment_of(program_of(m), m.assembly, i, p),
                                                             program_of(m).segments[i],
                                                             geometry_of<Follower, Digits50>(dimensions)));
            motion.start_lifts.push_back(p.start_lift);
            motion.plain_segments.push_back(
                with_contour<Follower>(segment_of(program_of(m), m.assembly, i,
                                                  parameters_of<double>(program_of(m), slots<Follower>, rounded, i)),
                                       program_of(m).segments[i], geometry_of<Follower, double>(rounded)));
        }
    }
};

/// What is to be greatest over some segments, as a function of the place: roughly, and in fifty digits.
struct Sought {
    const void* context;
    double (*rough)(const void* context, const Here<double>& here);
    Digits50 (*fine)(const void* context, const Here<Digits50>& here);
};

Digits50 find_greatest(const RebuiltMotion& motion, bool (*wanted)(SegmentKind), const Sought& f);

/// The greatest value over some segments of a measure: f(follower, here), in double and in fifty digits.
template <template <class> class Follower, class Function>
Digits50 greatest(const Rebuilt<Follower>& cam, bool (*wanted)(SegmentKind), const Function& f) {
    using Both = std::pair<const Rebuilt<Follower>*, const Function*>;
    const Both both{&cam, &f};
    return find_greatest(cam.motion, wanted,
                         {&both,
                          [](const void* context, const Here<double>& here) -> double {
                              const Both& at = *static_cast<const Both*>(context);
                              return (*at.second)(at.first->plain_follower, here);
                          },
                          [](const void* context, const Here<Digits50>& here) -> Digits50 {
                              const Both& at = *static_cast<const Both*>(context);
                              return (*at.second)(at.first->follower, here);
                          }});
}

}  // namespace mechwright::cam::again
