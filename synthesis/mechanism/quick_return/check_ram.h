#pragma once
/// \file
/// The checks of again.h as a template on the geometry. Included by the files that make them for a kind of mechanism.

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/mechanism/quick_return/again.h"
#include "synthesis/mechanism/quick_return/ram_places.h"

namespace mechwright::quick_return::again {

inline constexpr double end_within = 1e-12;  // of crank angles, and of margins over the unit of length
inline constexpr double no_margin = 1e-30;   // places are found to forty digits

inline std::string number(const Digits50& value) { return fmt::format("{:.9g}", value.convert_to<double>()); }

inline std::string degrees(const Digits50& radians) {
    const Digits50 angle = radians * 180 / boost::math::constants::pi<Digits50>();
    return number(abs(angle) < end_within ? Digits50(0) : angle) + " deg";
}

template <class Geometry>
Check check_dimensions(std::span<const Digits50> dimensions) {
    Check check{"dimensions are positive and finite", true, "the lengths are"};
    bool first = true;
    for (const std::size_t i : Geometry::lengths) {
        if (!(dimensions[i] > 0) || !isfinite(dimensions[i])) check.passed = false;
        check.detail += (first ? " " : ", ") + number(dimensions[i]);
        first = false;
    }
    return check;
}

/// How far the rod is from not reaching the slide at a crank angle.
struct RodPlace {
    Digits50 crank_angle;
    Digits50 margin;  ///< rod less the height it has to span, over the unit
    bool dead_end;    ///< an end of a limited motion, at which the rod is square to the slide to rounding
};

template <class Geometry>
std::vector<RodPlace> rod_places(const Rebuilt<Geometry>& m, const Motion& motion) {
    const Sweep sweep = sweep_of(motion);
    std::vector<RodPlace> all;
    const auto add = [&](const Digits50& x, bool end) {
        const auto s = m.at(x);
        const Digits50 margin = std::min(s.right.c[0], s.left.c[0]);
        all.push_back({x, margin, end && abs(margin) <= end_within});
    };
    add(Digits50(sweep.from), !motion.full_turn);
    add(Digits50(sweep.from / 2 + sweep.to / 2), false);
    for (const Digits50& x : stationary_crank_angles(m, sweep, Slope::rod_height))
        if (motion.full_turn || (x > sweep.from + end_within && x < sweep.to - end_within)) add(x, false);
    add(Digits50(sweep.to), !motion.full_turn);
    return all;
}

inline Check check_reach(const std::vector<RodPlace>& all, const Digits50& unit) {
    const auto least = std::min_element(all.begin(), all.end(),
                                        [](const RodPlace& a, const RodPlace& b) { return a.margin < b.margin; });
    const bool reaches =
        std::all_of(all.begin(), all.end(), [](const RodPlace& p) { return p.margin >= 0 || p.dead_end; });
    const std::string where = " at crank angle " + degrees(least->crank_angle);
    return {"rod reaches the slide over the whole motion", reaches,
            reaches ? "the least margin is " + number(unit * abs(least->margin)) + " (length)" + where
                    : "the rod is too short by " + number(-unit * least->margin) + " (length)" + where};
}

inline Check check_branch(const std::vector<RodPlace>& all, bool reaches) {
    const auto least = std::min_element(all.begin(), all.end(), [](const RodPlace& a, const RodPlace& b) {
        return a.dead_end != b.dead_end ? b.dead_end : a.margin < b.margin;
    });
    const bool ends = std::any_of(all.begin(), all.end(), [](const RodPlace& p) { return p.dead_end; });
    Check check{"rod stays on one branch", reaches && least->margin > no_margin, {}};
    if (!reaches)
        check.detail = "it does not reach the slide over the whole motion";
    else if (!check.passed)
        check.detail = "the rod stands square to the slide at crank angle " + degrees(least->crank_angle);
    else if (ends)
        check.detail = "the rod stands square to the slide only at the ends of the motion, which are dead positions";
    else
        check.detail = "the rod never stands square to the slide";
    return check;
}

template <class Geometry>
Check check_strokes(const Rebuilt<Geometry>& m, const Motion& motion) {
    const auto turns = turning_points(m, motion);
    std::string where;
    for (const Digits50& x : turns)
        where += (where.empty() ? "" : ", ") + degrees(x);
    return {"makes two strokes in each turn", turns.size() == 2, "the ram turns back at crank angles " + where};
}

inline bool passed(const std::vector<Check>& checks) {
    return std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.passed; });
}

template <class Geometry>
std::vector<Check> RamAgain<Geometry>::check_motion(const Motion& motion, Dimensions dimensions) {
    std::vector<Check> checks{check_dimensions<Geometry>(dimensions)};
    if (!checks.back().passed) return checks;
    if (!is_motion(motion)) {
        checks.push_back({"assembles over the whole motion", false,
                          motion.from > motion.to ? "it does not assemble at any crank angle"
                                                  : "the crank angles of the motion are not finite"});
        return checks;
    }
    for (Check& check : Geometry::checks_of_input(motion, dimensions))
        checks.push_back(std::move(check));
    if (!passed(checks)) return checks;
    const Rebuilt<Geometry> m(motion.assembly, dimensions);
    const auto places = rod_places(m, motion);
    checks.push_back(check_reach(places, m.unit));
    checks.push_back(check_branch(places, checks.back().passed));
    if (motion.family == two_strokes && motion.full_turn && checks.back().passed)
        checks.push_back(check_strokes(m, motion));
    return checks;
}

}  // namespace mechwright::quick_return::again
