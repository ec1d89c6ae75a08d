#pragma once
/// \file
/// Measures of mechanisms whose gradients are taken in several ways. Each is a template for its value, and says how its
/// gradient follows from the loop it closes (implicit function theorem): the equations F(u, p) = 0 of the unknowns u
/// and the dimensions p are solved once, du/dp = -(dF/du)^-1 dF/dp.

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include "analysis/cam/roller_follower.h"
#include "analysis/cam/segment.h"
#include "analysis/four_bar.h"
#include "analysis/four_bar/coupler_gradient.h"
#include "analysis/quick_return.h"

namespace mechwright::bench {

inline constexpr std::size_t gradient_places = 24;

/// Crank angle number `place`, spread over the turn so that none lies on the ground line.
inline double crank_angle_at(std::size_t place) {
    return 2 * std::numbers::pi * (static_cast<double>(place) + 0.3) / static_cast<double>(gradient_places);
}

template <std::size_t n>
struct ValueAndGradient {
    double value;
    std::array<double, n> gradient;
};

/// The squared distance of a coupler point from a target, over the links and the point's coordinates.
struct CouplerPointMiss {
    static constexpr std::string_view name = "coupler point";
    static constexpr std::size_t size = 6;
    static constexpr Vector<double> target{60, 70};

    static std::array<double, size> dimensions(std::size_t) { return {100, 25, 90, 75, 45, 20}; }

    template <class T>
    static T value(const std::array<T, size>& x, std::size_t place) {
        const FourBar<T> m{x[0], x[1], x[2], x[3]};
        const auto p = position(m, CouplerPoint<T>{x[4], x[5]}, pose(m, T(crank_angle_at(place)), Assembly::open));
        const Vector<T> miss = p - Vector<T>{T(target.x), T(target.y)};
        return dot(miss, miss);
    }

    static ValueAndGradient<size> by_loop(const std::array<double, size>& x, std::size_t place) {
        const FourBar<double> m{x[0], x[1], x[2], x[3]};
        const CouplerPoint<double> point{x[4], x[5]};
        const auto p = pose(m, crank_angle_at(place), Assembly::open);
        const Vector<double> miss = position(m, point, p) - target;
        const auto gradient = position_gradient(m, point, p);
        ValueAndGradient<size> out{dot(miss, miss), {}};
        for (std::size_t i = 0; i < size; ++i)
            out.gradient[i] = 2 * dot(miss, gradient[i]);
        return out;
    }
};

/// The transmission angle with coupler and rocker stretched out but for a millionth of their length.
struct AngleNearToggle {
    static constexpr std::string_view name = "transmission angle near a toggle";
    static constexpr std::size_t size = 4;

    static std::array<double, size> dimensions(std::size_t place) {
        constexpr double left = 1e-6, rocker = 40;
        const FourBar<double> m{100, 25, 60, rocker};
        const double diagonal = assembly_margins(m, half_turn(crank_angle_at(place))).diagonal;
        return {m.ground, m.crank, diagonal * (1 + left) - rocker, rocker};
    }

    template <class T>
    static T value(const std::array<T, size>& x, std::size_t place) {
        return transmission_angle(FourBar<T>{x[0], x[1], x[2], x[3]}, half_turn(T(crank_angle_at(place))));
    }

    /// F = crank e + coupler w - ground x - rocker v; its unknowns are the angles of w and v, whose difference is asked
    /// for. Multiplied by v and by w each equation has one unknown.
    static ValueAndGradient<size> by_loop(const std::array<double, size>& x, std::size_t place) {
        const FourBar<double> m{x[0], x[1], x[2], x[3]};
        const auto p = pose(m, crank_angle_at(place), Assembly::open);
        const std::array<Vector<double>, size> right_sides{{{1, 0}, -p.crank, -p.coupler, p.rocker}};
        ValueAndGradient<size> out{std::atan2(p.transmission_sine, p.transmission_cosine), {}};
        for (std::size_t i = 0; i < size; ++i)
            out.gradient[i] = (dot(right_sides[i], p.coupler) / m.rocker - dot(right_sides[i], p.rocker) / m.coupler) /
                              p.transmission_sine;
        return out;
    }
};

/// The velocity of the ram of an offset slider-crank, for unit crank speed.
struct RamVelocity {
    static constexpr std::string_view name = "ram velocity";
    static constexpr std::size_t size = 3;

    static std::array<double, size> dimensions(std::size_t) { return {40, 120, 25}; }

    template <class T>
    static T value(const std::array<T, size>& x, std::size_t place) {
        return ram_velocity(SliderCrank<T>{x[0], x[1], x[2]}, T(crank_angle_at(place)));
    }

    /// F = crank e + rod w - (position, offset); its unknowns are the angle of w and the position. The velocities solve
    /// its derivative in time, and their derivatives that equation differentiated by the dimensions: three times the
    /// same matrix.
    static ValueAndGradient<size> by_loop(const std::array<double, size>& x, std::size_t place) {
        const SliderCrank<double> m{x[0], x[1], x[2]};
        const auto p = pose(m, crank_angle_at(place));
        struct Turn {
            double rod, ram;
        };
        const auto solved = [&](const Vector<double>& right) {
            const double rod = right.y / (m.rod * p.rod.x);
            return Turn{rod, -right.x - m.rod * p.rod.y * rod};
        };
        const Turn velocity = solved(-m.crank * left_of(p.crank));
        const std::array<Vector<double>, size> pose_right{{-p.crank, -p.rod, {0, 1}}};
        const std::array<Vector<double>, size> velocity_right{
            {-left_of(p.crank), -velocity.rod * left_of(p.rod), {0, 0}}};
        ValueAndGradient<size> out{velocity.ram, {}};
        for (std::size_t i = 0; i < size; ++i) {
            const double turned = m.rod * velocity.rod * solved(pose_right[i]).rod;
            out.gradient[i] = solved(velocity_right[i] + turned * p.rod).ram;
        }
        return out;
    }
};

/// The pressure angle of an oscillating roller in a cycloidal rise, over prime radius, pivot distance and arm.
struct CamPressureAngle {
    static constexpr std::string_view name = "pressure angle of a cam";
    static constexpr std::size_t size = 3;

    static std::array<double, size> dimensions(std::size_t) { return {36, 93, 80}; }

    static cam::Lift<double> lift(std::size_t place) {
        const cam::Segment<double> rise{
            cam::SegmentKind::rise, {cam::SegmentLaw::Form::law, cam::Law::cycloidal, false}, 1.5, 0.4};
        return cam::lift_at(rise, 0, crank_angle_at(place) / (2 * std::numbers::pi), 0.0);
    }

    template <class T>
    static T value(const std::array<T, size>& x, std::size_t place) {
        const cam::Lift<double> f = lift(place);
        const cam::OscillatingRoller<T> follower{x[0], x[1], x[2], T(8), 1};
        return pressure_angle(pitch_point(follower, cam::Lift<T>{T(f.s), T(f.v), T(f.a), T(f.j)}));
    }

    /// F = pivot^2 + arm^2 - 2 pivot arm cos(start) - prime^2; its unknown is the start angle of the arm.
    static ValueAndGradient<size> by_loop(const std::array<double, size>& x, std::size_t place) {
        const auto& [prime, pivot, arm] = x;
        const cam::Lift<double> f = lift(place);
        const double start = angle(arm_start(cam::OscillatingRoller<double>{prime, pivot, arm, 8, 1}));
        const double sine = std::sin(start), cosine = std::cos(start), both = pivot * arm * sine;
        const std::array<double, size> by_start{prime / both, (arm * cosine - pivot) / both,
                                                (pivot * cosine - arm) / both};
        const double s = std::sin(start + f.s), c = std::cos(start + f.s);
        const double across = pivot * s, along = arm * (f.v + 1) - pivot * c;
        const std::array<Vector<double>, size> direct{{{0, 0}, {s, -c}, {0, f.v + 1}}};  // of (across, along)
        ValueAndGradient<size> out{std::atan2(along, across), {}};
        for (std::size_t i = 0; i < size; ++i) {
            const Vector<double> change = direct[i] + by_start[i] * Vector<double>{pivot * c, pivot * s};
            out.gradient[i] = (across * change.y - along * change.x) / (across * across + along * along);
        }
        return out;
    }
};

}  // namespace mechwright::bench
