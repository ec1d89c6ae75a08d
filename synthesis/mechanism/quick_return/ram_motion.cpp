#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "synthesis/mechanism/over_range.h"
#include "synthesis/mechanism/quick_return/again.h"
#include "synthesis/mechanism/quick_return/ram_places.h"

namespace mechwright::quick_return {

namespace {

using namespace again;

constexpr std::size_t two_strokes = 0, limited = 1;  // families
constexpr double turn = 2 * std::numbers::pi;
constexpr double as_wide_within = 1e-9;  // radians

/// What has to be at least 0 for the mechanism to assemble: how much rod is left on both sides of the slide, and at a
/// drag link how far its four-bar is from being stretched and folded.
template <class Geometry>
struct Margins {
    Rebuilt<Geometry> m;

    static constexpr std::size_t count = std::is_same_v<Geometry, DragLinkGeometry> ? 4 : 2;

    double at(std::size_t k, double x) const { return margin(k, m.plain_input, x); }
    Digits50 at(std::size_t k, const Digits50& x) const { return margin(k, m.input, x); }

    template <class Input, class T>
    T margin(std::size_t k, const Input& input, const T& crank_angle) const {
        if constexpr (count == 4) {
            if (k >= 2) {
                const auto pose = four_bar::again::pose(input.linkage, crank_angle);
                return k == 2 ? pose.stretch : pose.fold;
            }
        }
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

/// Whether the input turns or swings as the mechanism's name says, and the rod never stops it.
template <class Geometry>
bool works(std::span<const Digits50> d) {
    if constexpr (std::is_same_v<Geometry, SliderCrankGeometry>) return d[0] + abs(d[2]) <= d[1];
    if constexpr (std::is_same_v<Geometry, CrankShaperGeometry>) return d[1] < d[0];
    if constexpr (std::is_same_v<Geometry, WhitworthGeometry>) return d[1] > d[0] && d[2] <= d[3];
    if constexpr (std::is_same_v<Geometry, DragLinkGeometry>)
        return d[0] + d[1] <= d[2] + d[3] && d[0] + abs(d[2] - d[3]) <= d[1] && d[4] + abs(d[8]) <= d[6];
}

}  // namespace

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
        if (works<Geometry>(dimensions) && turning_points(margins.m, motion).size() == 2) motion.family = two_strokes;
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

template Motion RamAgain<SliderCrankGeometry>::motion(Form, Dimensions, const std::optional<Vector<Digits50>>&);
template Motion RamAgain<CrankShaperGeometry>::motion(Form, Dimensions, const std::optional<Vector<Digits50>>&);
template Motion RamAgain<WhitworthGeometry>::motion(Form, Dimensions, const std::optional<Vector<Digits50>>&);
template Motion RamAgain<DragLinkGeometry>::motion(Form, Dimensions, const std::optional<Vector<Digits50>>&);

}  // namespace mechwright::quick_return
