#pragma once
/// \file
/// At which crank angles a ram-driving mechanism assembles, and whether it works as it is meant to: the crank turns
/// fully and the ram makes two strokes in each turn.

#include "analysis/numbers/graded_grid.h"
#include "analysis/quick_return/extremes.h"

namespace mechwright {

inline bool makes_two_strokes(const SliderCrank<double>& m) {
    const RodMargins<double> margin = rod_margins(m);
    return margin.crank_right >= 0 && margin.crank_left >= 0;
}

inline bool makes_two_strokes(const CrankShaper<double>& m) {
    const CrankShaperMargins<double> margin = margins(m);
    return margin.swings > 0 && margin.reaches_upright >= 0 && margin.reaches_ends >= 0 && margin.pulls_at_outer >= 0 &&
           margin.pulls_at_inner >= 0;
}

inline bool makes_two_strokes(const Whitworth<double>& m) { return m.crank > m.centre_distance && m.rod >= m.arm; }

inline bool makes_two_strokes(const DragLink<double>& m) {
    const FullTurnMargins<double> margin = double_crank_margins(m.links);
    return margin.ground_longest >= 0 && margin.coupler_longest >= 0 && margin.rocker_longest >= 0 &&
           makes_two_strokes(output_of(m));
}

namespace detail {

/// The crank angles at which what drives the arm assembles.
template <class Drive>
CrankRange<double> input_range(const Drive&) {
    return {true, 0, 2 * std::numbers::pi};
}
inline CrankRange<double> input_range(const DragLink<double>& m) { return assembled_range(m.links); }

/// How much rod is left where less of it is.
template <class Drive>
double rod_margin(const Drive& m, double crank_angle) {
    const auto p = pose_at(m, crank_angle);
    return std::min(ram_of(p).left, ram_of(p).right);
}

/// Where the rod stands square to the slide over one range of the input, in order. What is left of it on either side is
/// a smooth function of its own: no range between two zeros is too narrow to be seen.
template <class Drive>
CrankAngles<2 * RamExtremes::capacity> square_rods(const Drive& m, const CrankRange<double>& input) {
    const FastPlaces fast = fast_places(m);
    CrankAngles<2 * RamExtremes::capacity> found;
    const auto add_zeros = [&](auto side) {
        const auto margin = [&](double x) { return ram_of(pose_at(m, x)).*side; };
        const auto zeros = zeros_of_motion<RamExtremes::capacity>(
            margin, fast.all(), input,
            {.widest = std::numbers::pi / 180, .end_part = input.full_turn ? 1.0 : 1.0 / 32});
        for (const double x : zeros.all())
            found.add(x);
    };
    add_zeros(&SliderCrankPose<double>::left);
    add_zeros(&SliderCrankPose<double>::right);
    std::sort(found.at.begin(), found.at.begin() + found.count);
    return found;
}

/// The widest of several ranges; of equally wide ones (mirror images of each other, whose widths differ by rounding)
/// the first from crank angle 0 on.
struct WidestRange {
    CrankRange<double> range{false, 1, 0};

    void consider(double from, double to) {
        constexpr double turn = 2 * std::numbers::pi;
        constexpr double as_wide_within = 1e-9;  // radians
        if (from < 0) return consider(from + turn, to + turn);
        const double more = (to - from) - (range.to - range.from);
        if (more > as_wide_within || (more > -as_wide_within && from < range.from)) range = {false, from, to};
    }
};

}  // namespace detail

/// The crank angles at which a mechanism assembles; of several ranges the widest, of equally wide ones the first from
/// crank angle 0 on. Empty (from > to) if there are none.
template <class Drive>
CrankRange<double> assembled_range(const Drive& m) {
    constexpr double turn = 2 * std::numbers::pi;
    const CrankRange<double> full{true, 0, turn};
    if (makes_two_strokes(m)) return full;
    detail::WidestRange widest;
    const auto consider = [&](double from, double to) {
        if (to > from && detail::rod_margin(m, 0.5 * (from + to)) > 0) widest.consider(from, to);
    };
    const auto consider_parts = [&](const CrankRange<double>& input) {
        const auto ends = detail::square_rods(m, input);
        double from = input.from;
        for (const double x : ends.all()) {
            consider(from, x);
            from = x;
        }
        consider(from, input.to);
    };
    const CrankRange<double> input = detail::input_range(m);
    if (!input.full_turn) {
        if (input.from > input.to) return widest.range;
        consider_parts(input);
        if (input.mirrored) consider_parts({false, turn - input.to, turn - input.from});
        return widest.range;
    }
    const auto ends = detail::square_rods(m, full);
    if (ends.count == 0) return detail::rod_margin(m, 0.0) >= 0 ? full : widest.range;
    for (std::size_t i = 0; i < ends.count; ++i)
        consider(ends.at[i], i + 1 < ends.count ? ends.at[i + 1] : ends.at[0] + turn);
    return widest.range;
}

}  // namespace mechwright
