#pragma once
/// \file
/// At which crank angles a ram-driving mechanism assembles, and whether it works as it is meant to: the crank turns
/// fully and the ram makes two strokes in each turn.

#include "analysis/numbers/graded_grid.h"
#include "analysis/quick_return/extremes.h"

namespace mechwright {

/// The least length by which the mechanism closes at a crank angle; < 0 by how much it fails.
template <class Drive>
double assembly_margin(const Drive& m, double crank_angle) {
    const auto p = pose_at(m, crank_angle);
    const SliderCrankPose<double>& ram = ram_of(p);
    return std::min(ram.left, ram.right);
}

/// Where the four-bar does not close, the ram has no place.
inline double assembly_margin(const DragLink<double>& m, double crank_angle) {
    const auto p = pose_at(m, crank_angle);
    const double closes = std::min(p.input.margins.stretch, p.input.margins.fold);
    return closes < 0 ? closes : std::min({closes, p.output.left, p.output.right});
}

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

/// The crank angles at which a mechanism assembles; of several ranges the widest, of equally wide ones (mirror images
/// of each other, whose widths differ by rounding) the first from crank angle 0 on. Empty (from > to) if there are
/// none.
template <class Drive>
CrankRange<double> assembled_range(const Drive& m) {
    constexpr double turn = 2 * std::numbers::pi;
    constexpr double as_wide_within = 1e-9;  // radians
    if (makes_two_strokes(m)) return {true, 0, turn};
    const CrankRange<double> full{true, 0, turn};
    const auto margin = [&](double crank_angle) { return assembly_margin(m, crank_angle); };
    const FastPlaces fast = fast_places(m);
    const auto ends =
        zeros_of_motion<RamExtremes::capacity>(margin, fast.all(), full, {.widest = std::numbers::pi / 180});
    CrankRange<double> widest{false, 1, 0};
    if (ends.count == 0) return margin(0) >= 0 ? full : widest;
    for (std::size_t i = 0; i < ends.count; ++i) {
        const double from = ends.at[i];
        const double to = i + 1 < ends.count ? ends.at[i + 1] : ends.at[0] + turn;
        const bool wider = to - from > widest.to - widest.from + as_wide_within;
        if (wider && margin(0.5 * (from + to)) > 0) widest = {false, from, to};
    }
    return widest;
}

}  // namespace mechwright
