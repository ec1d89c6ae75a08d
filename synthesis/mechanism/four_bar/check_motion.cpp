#include <fmt/format.h>

#include <limits>

#include "synthesis/mechanism/four_bar/linkage_again.h"
#include "synthesis/mechanism/four_bar/measure_again.h"

namespace mechwright {

namespace {

using namespace four_bar::again;

std::string number(const Digits50& value) { return fmt::format("{:.9g}", value.convert_to<double>()); }

std::string degrees(const Digits50& radians) {
    constexpr double end_within = 1e-12;
    const Digits50 angle = radians * 180 / boost::math::constants::pi<Digits50>();
    return number(abs(angle) < end_within ? Digits50(0) : angle) + " deg";
}

/// How far a position is from coming apart and from changing its branch.
struct Position {
    Digits50 crank_angle;
    Digits50 margin;  ///< length by which the loop closes, < 0 by which it fails to
    Digits50 sine;    ///< of the transmission angle, > 0 on the branch of the assembly
    bool toggle_end;  ///< an end of a limited motion, at which coupler and rocker are in line to rounding
};

/// Distance of the diagonal to the nearer of its limits |coupler - rocker| and coupler + rocker.
Digits50 margin(const Linkage<Digits50>& m, const Pose<Digits50>& p) {
    const Digits50 diagonal = sqrt(dot(p.diagonal, p.diagonal));
    const Digits50 stretch = p.stretch / (m.coupler + m.rocker + diagonal);
    const Digits50 both = diagonal + abs(m.coupler - m.rocker);
    const Digits50 fold = both > 0 ? Digits50(p.fold / both) : Digits50(0);
    return stretch < fold ? stretch : fold;
}

/// Everywhere on the motion where margin or sine can be least: where the diagonal or the transmission angle is
/// stationary, the ends, and one place between them.
std::vector<Position> positions(const Motion& motion, std::span<const Digits50> dimensions) {
    const double end_within = 1e-12;  // of crank angles, and of margins over the unit of length
    const auto m = linkage(motion.assembly, dimensions);
    const Digits50 unit = length_unit(dimensions);
    const Sweep sweep = sweep_of(motion);
    std::vector<Position> all;
    const auto add = [&](const Digits50& x, bool end) {
        const auto p = pose(m, x);
        const Digits50 closed = margin(m, p);
        const Digits50 sine = m.side * cross(p.coupler, p.rocker) / (m.coupler * m.rocker);
        all.push_back({x, unit * closed, sine, end && abs(closed) <= end_within});
    };
    add(Digits50(sweep.from), !motion.full_turn);
    add(Digits50(sweep.from / 2 + sweep.to / 2), false);
    for (const auto& stationary :
         {stationary_crank_angles<Diagonal>(m, sweep), stationary_crank_angles<TransmissionAngle>(m, sweep)})
        for (const Digits50& x : stationary)
            if (motion.full_turn || (x > sweep.from + end_within && x < sweep.to - end_within)) add(x, false);
    add(Digits50(sweep.to), !motion.full_turn);
    return all;
}

Check check_dimensions(std::span<const Digits50> dimensions) {
    Check check{"dimensions are positive and finite", true, "the lengths are"};
    for (std::size_t i = 0; i < 4; ++i) {
        if (!(dimensions[i] > 0) || !isfinite(dimensions[i])) check.passed = false;
        check.detail += (i > 0 ? ", " : " ") + number(dimensions[i]);
    }
    return check;
}

Check check_assembly(const std::vector<Position>& all) {
    const auto least = std::min_element(all.begin(), all.end(),
                                        [](const Position& a, const Position& b) { return a.margin < b.margin; });
    const bool closes =
        std::all_of(all.begin(), all.end(), [](const Position& p) { return p.margin >= 0 || p.toggle_end; });
    const std::string where = " at crank angle " + degrees(least->crank_angle);
    return {"assembles over the whole motion", closes,
            closes ? "the least margin is " + number(abs(least->margin)) + " (length)" + where
                   : "the loop fails to close by " + number(-least->margin) + " (length)" + where};
}

/// What is special about a linkage all of whose pins can fall into one line.
std::string change_point_name(std::span<const Digits50> d) {
    if (d[0] == d[2] && d[1] == d[3]) return "a parallelogram, whose pins fall into one line";
    if ((d[0] == d[1] && d[2] == d[3]) || (d[0] == d[3] && d[1] == d[2]))
        return "a kite, whose pins fall into one line";
    return four_bar::grashof_margin_again({}, d) == 0 ? "a change point, where all pins fall into one line"
                                                      : "a toggle, where coupler and rocker fall into one line";
}

Check check_branch(const std::vector<Position>& all, std::span<const Digits50> dimensions) {
    // Toggles at the ends come last; there is always a position between.
    const auto less = [](const Position& a, const Position& b) {
        return a.toggle_end != b.toggle_end ? b.toggle_end : a.sine < b.sine;
    };
    const auto least = std::min_element(all.begin(), all.end(), less);
    const bool toggles = std::any_of(all.begin(), all.end(), [](const Position& p) { return p.toggle_end; });
    // Places are found to forty digits. The sine of a linkage of rounded lengths is zero there, or far from it.
    constexpr double zero = 1e-30;
    Check check{"stays on one branch", least->sine > zero, {}};
    const std::string where = number(abs(least->sine)) + " at crank angle " + degrees(least->crank_angle);
    if (!check.passed)
        check.detail = "the sine of the transmission angle falls to " + where + ": " + change_point_name(dimensions);
    else if (toggles)
        check.detail =
            "the sine of the transmission angle keeps its sign and vanishes only at the ends of the motion, "
            "which are toggles";
    else
        check.detail = "the sine of the transmission angle keeps its sign; its least absolute value is " + where;
    return check;
}

/// Between two toggles, and over the full turn of a Grashof linkage, a position moves on without a gap and without
/// meeting the other branch: it cannot leave its circuit.
Check check_circuit(const Motion& motion, bool stays_on_branch, std::span<const Digits50> dimensions) {
    const Digits50 margin = four_bar::grashof_margin_again(motion, dimensions);
    Check check{"stays on one circuit", stays_on_branch && (!motion.full_turn || margin > 0), {}};
    const std::string grashof =
        "Grashof margin " + number(margin) + " (" + number(margin / longest_link(dimensions)) + " of the longest link)";
    if (!motion.full_turn)
        check.detail = check.passed ? "all crank angles from " + degrees(motion.from) + " to " + degrees(motion.to) +
                                          " lie in one range in which it assembles"
                                    : "the crank angles from " + degrees(motion.from) + " to " + degrees(motion.to) +
                                          " do not lie in one range in which it assembles";
    else
        check.detail = grashof + (check.passed ? ": its two assemblies are separate circuits"
                                               : ": its two assemblies are not separate circuits");
    return check;
}

}  // namespace

std::vector<Check> four_bar_check_motion(const Motion& motion, std::span<const Digits50> dimensions) {
    std::vector<Check> checks{check_dimensions(dimensions)};
    if (!checks.back().passed) return checks;
    if (!is_motion(motion)) {
        const std::string why = motion.from > motion.to ? "it does not assemble at any crank angle"
                                                        : "the crank angles of the motion are not finite";
        for (const char* name : {"assembles over the whole motion", "stays on one branch", "stays on one circuit"})
            checks.push_back({name, false, why});
        return checks;
    }
    const auto all = positions(motion, dimensions);
    checks.push_back(check_assembly(all));
    const bool assembles = checks.back().passed;
    checks.push_back(check_branch(all, dimensions));
    if (!assembles) {
        checks.back().passed = false;
        checks.back().detail = "it does not assemble over the whole motion";
    }
    const bool one_branch = checks.back().passed;
    checks.push_back(check_circuit(motion, one_branch, dimensions));
    return checks;
}

}  // namespace mechwright
