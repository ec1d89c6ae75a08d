#pragma once
/// \file
/// The motion of again.h as a template on the geometry. Included by the files that make it for a kind of mechanism.

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "synthesis/mechanism/over_range.h"
#include "synthesis/mechanism/quick_return/again.h"
#include "synthesis/mechanism/quick_return/ram_places.h"

namespace mechwright::quick_return::again {

inline constexpr double turn = 2 * std::numbers::pi;
inline constexpr double as_wide_within = 1e-9;  // radians

/// What has to be at least 0 for the mechanism to assemble: how much rod is left on both sides of the slide, and at a
/// drag link how far its four-bar is from being stretched and folded.
template <class Geometry>
struct Margins {
    Rebuilt<Geometry> m;

    static constexpr std::size_t count = 2 + Geometry::input_margins;

    double at(std::size_t k, double x) const { return margin(k, m.plain_input, x); }
    Digits50 at(std::size_t k, const Digits50& x) const { return margin(k, m.input, x); }

    template <class Input, class T>
    T margin(std::size_t k, const Input& input, const T& crank_angle) const {
        if constexpr (count > 2)
            if (k >= 2) return Geometry::margins_of_input(input, crank_angle)[k - 2];
        const auto state = m.at(crank_angle);
        return k == 0 ? state.right.c[0] : state.left.c[0];
    }

    bool assembles(const Digits50& x) const {
        for (std::size_t k = 0; k < count; ++k)
            if (!(at(k, x) >= 0)) return false;
        return true;
    }

    /// Where one of them changes its sign, in order over a turn.
    std::vector<Digits50> zeros() const {
        const Sweep sweep{0, turn};
        std::vector<double> fast;
        const auto height_slope = [&](double x) { return m.at(x).height.c[1]; };
        for (const Bracket& b : brackets_of_zeros(height_slope, sample_angles(sweep)))
            fast.push_back((b.left + b.right) / 2);
        std::vector<Digits50> found;
        for (std::size_t k = 0; k < count; ++k)
            for (const Digits50& zero : stationary_points(
                     sweep, [&](double x) { return at(k, x); }, [&](const Digits50& x) { return at(k, x); }, fast))
                found.push_back(zero);
        std::sort(found.begin(), found.end());
        return found;
    }
};

template <class Geometry>
Motion RamAgain<Geometry>::motion(Form form, Dimensions dimensions,
                                  const std::optional<Vector<Digits50>>& crank_range) {
    Motion motion;
    motion.assembly = form.assembly;
    motion.family = limited;
    motion.to = turn;
    // Over a range a ram makes no strokes.
    if (crank_range) return over_range(motion, *crank_range);
    const Margins<Geometry> margins{Rebuilt<Geometry>(form.assembly, dimensions)};
    const std::vector<Digits50> ends = margins.zeros();
    const Digits50& whole = boost::math::constants::two_pi<Digits50>();
    const auto end = [&](std::size_t i) { return i < ends.size() ? ends[i] : Digits50(ends[i - ends.size()] + whole); };
    std::vector<bool> assembled;
    for (std::size_t i = 0; i < ends.size(); ++i)
        assembled.push_back(margins.assembles((end(i) + end(i + 1)) / 2));
    const bool everywhere = ends.empty() ? margins.assembles(Digits50(0))
                                         : std::all_of(assembled.begin(), assembled.end(), [](bool b) { return b; });
    if (everywhere) {
        motion.full_turn = true;
        if (Geometry::works(dimensions) && turning_points(margins.m, motion).size() == 2) motion.family = two_strokes;
        return motion;
    }
    motion.full_turn = false;
    motion.from = 1;
    motion.to = 0;
    Digits50 widest = -1;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (!assembled[i] || assembled[(i + ends.size() - 1) % ends.size()]) continue;  // not where a range begins
        std::size_t last = i;
        while (assembled[last % ends.size()])
            ++last;
        const Digits50 width = end(last) - end(i);
        if (!(width > widest + as_wide_within)) continue;
        widest = width;
        motion.from = end(i).template convert_to<double>();
        motion.to = end(last).template convert_to<double>();
    }
    return motion;
}

}  // namespace mechwright::quick_return::again
