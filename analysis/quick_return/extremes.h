#pragma once
/// \file
/// The crank angles at which speed and acceleration of the ram are extreme: every stationary point over the continuous
/// motion, to rounding.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "analysis/numbers/graded_grid.h"
#include "analysis/quick_return/rod_swing.h"

namespace mechwright {

/// Stationary points of one measure along a turn; no drive has nearly as many.
using RamExtremes = CrankAngles<24>;

struct FastPlaces {
    std::array<FastPlace, 8> place{};
    std::size_t count = 0;

    void add(double angle, double scale) { place[count++] = {angle, scale}; }
    std::span<const FastPlace> all() const& { return {place.data(), count}; }
    std::span<const FastPlace> all() const&& = delete;  // they would be gone
};

namespace detail {

/// How far a complex arm angle is from the real one square to the slide where the rod stands square to it too, of which
/// `margin` of its length is left: cosh of it exceeds 1 by margin / arm.
inline double square_rod_scale(double margin, double arm) {
    return 2 * std::asinh(std::sqrt(std::abs(margin) / (2 * arm)));
}

/// The same for a crank and an arm driven by it, which is `ratio` times as fast there.
inline void add_square_rod(FastPlaces& places, double crank_angle, double margin, double arm, double ratio) {
    places.add(crank_angle, square_rod_scale(margin, arm) / std::max(std::abs(ratio), 1e-12));
}

/// The two places where a fully turning arm stands square to the slide.
template <class Drive>
void add_square_rods(FastPlaces& places, const Drive& m) {
    const SliderCrank<double> output = output_of(m);
    const RodMargins<double> margin = rod_margins(output);
    const std::array<double, 2> at = rod_turning_points(m);
    const auto ratio = [&](double x) { return ram_of(velocity(m, pose_at(m, x))).crank; };
    add_square_rod(places, at[0], margin.crank_left, output.crank, ratio(at[0]));
    add_square_rod(places, at[1], margin.crank_right, output.crank, ratio(at[1]));
}

/// The crank pin passes close to the arm pivot: complex crank angles with cosh(y) = (d^2 + r^2) / (2 d r).
inline void add_slot_flip(FastPlaces& places, const SlottedArm<double>& m) {
    places.add(std::numbers::pi,
               2 * std::asinh(0.5 * std::abs(m.centre_distance - m.crank) / std::sqrt(m.centre_distance * m.crank)));
}

}  // namespace detail

inline FastPlaces fast_places(const SliderCrank<double>& m) {
    FastPlaces places;
    detail::add_square_rods(places, m);
    return places;
}

inline FastPlaces fast_places(const Whitworth<double>& m) {
    FastPlaces places;
    detail::add_slot_flip(places, input_of(m));
    detail::add_square_rods(places, m);
    return places;
}

inline FastPlaces fast_places(const DragLink<double>& m) {
    FastPlaces places;
    places.add(0, detail::fastest_scale(m.links, {1, 0}));
    places.add(std::numbers::pi, detail::fastest_scale(m.links, {0, 1}));
    detail::add_square_rods(places, m);
    return places;
}

/// The rod comes closest to square with the lever upright and at the ends of its swing, where the lever angle is
/// stationary and the distance to the singularity a square root.
inline FastPlaces fast_places(const CrankShaper<double>& m) {
    FastPlaces places;
    detail::add_slot_flip(places, input_of(m));
    const auto margin = margins(m);
    const auto ratio = [&](double x) { return velocity(input_of(m), pose(input_of(m), half_turn(x))).arm; };
    for (const double upright : {0.0, std::numbers::pi})
        detail::add_square_rod(places, upright, margin.reaches_upright, m.lever, ratio(upright));
    const double end = 0.5 * strokes(m).outward;
    const auto p = pose(input_of(m), half_turn(end));
    const double curvature = std::abs(acceleration(input_of(m), p, velocity(input_of(m), p)).arm);
    const double swing = std::abs(margin.reaches_ends) / (m.lever * std::max(p.arm.y, 1e-12));
    const double scale = std::sqrt(2 * swing / std::max(curvature, 1e-12));
    places.add(end, scale);
    places.add(-end, scale);
    return places;
}

namespace detail {

/// The steps of the grid are finer the more often a derivative changes its sign near a fast place.
template <class Drive, class Function>
RamExtremes zeros_of_ram(const Drive& m, const CrankRange<double>& range, const Function& g,
                         double graded = GradedGrid::Steps{}.graded) {
    const FastPlaces fast = fast_places(m);
    // A limited motion can end at a dead position, where the ram is infinitely fast: finer steps there.
    return zeros_of_motion<RamExtremes::capacity>(
        g, fast.all(), range,
        {.graded = graded, .widest = std::numbers::pi / 48, .end_part = range.full_turn ? 1.0 : 1.0 / 32});
}

}  // namespace detail

/// Where the ram turns back.
template <class Drive>
RamExtremes ram_position_extremes(const Drive& m, const CrankRange<double>& range) {
    return detail::zeros_of_ram(m, range, [&](double x) { return ram_velocity(m, x); });
}

/// Where its velocity is stationary.
template <class Drive>
RamExtremes ram_velocity_extremes(const Drive& m, const CrankRange<double>& range) {
    return detail::zeros_of_ram(m, range, [&](double x) { return ram_acceleration(m, x); });
}

/// Where its acceleration is stationary.
template <class Drive>
RamExtremes ram_acceleration_extremes(const Drive& m, const CrankRange<double>& range) {
    constexpr double graded = 0.3;
    return detail::zeros_of_ram(
        m, range, [&](double x) { return ram_jerk(m, x); }, graded);
}

/// Where the rod's slope is stationary.
template <class Drive>
RamExtremes rod_extremes(const Drive& m, const CrankRange<double>& range) {
    return detail::zeros_of_ram(m, range, [&](double x) { return ram_of(velocity(m, pose_at(m, x))).rod; });
}

}  // namespace mechwright
