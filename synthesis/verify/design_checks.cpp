#include "synthesis/verify/design_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "synthesis/mechanism/cycle.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/affine.h"
#include "synthesis/problem/input_tasks.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

/// Both are rounded, in the unit of the file perhaps twice.
constexpr double tied_within = 1e-14;

/// All four are rounded.
bool is_whole_steps(double value, double min, double max, double step) {
    const double steps = (value - min) / step;
    const double rounded = 8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(min), std::abs(max));
    return std::abs(steps - std::round(steps)) * step <= rounded;
}

/// Why a dimension of the design is not what was asked for; empty if it is. What was given as one number must be that
/// number, what was not given must be 0; ranges may be left by the tolerance, relative to their greater limit.
std::string dimension_defect(const Claim& claim, std::size_t i) {
    const double value = claim.design[i];
    const auto defect = [&](std::string_view why, double number) {
        return fmt::format("{} is {}, {} {}", claim.mechanism->dimensions[i].name, value, why, number);
    };
    const auto unlike_all = [&] {
        return fmt::format("{} is {}, the choices are {}", claim.mechanism->dimensions[i].name, value,
                           fmt::join(claim.given[i]->choices, ", "));
    };
    if (!claim.given[i]) return value == 0 ? "" : defect("not given and must be", 0);
    const auto& [min, max, tie, choices, step] = *claim.given[i];
    if (claim.given[i]->tied()) {
        const double asked = tie.at(std::span<const double>(claim.design));
        double size = std::abs(tie.constant);
        for (const auto& [other, times] : tie.terms)
            size += std::abs(times * claim.design[other]);
        const auto name = [&](std::size_t k) { return std::string(claim.mechanism->dimensions[k].name); };
        return std::abs(value - asked) <= tied_within * size ? "" : defect(text_of(tie, name) + " is", asked);
    }
    if (min == max) return value == min ? "" : defect("given was", min);
    const double slack = claim.tolerance * std::max(std::abs(min), std::abs(max));
    if (!choices.empty()) return std::find(choices.begin(), choices.end(), value) != choices.end() ? "" : unlike_all();
    if (value < min - slack) return defect("the least allowed is", min);
    if (value > max + slack) return defect("the greatest allowed is", max);
    return step > 0 && !is_whole_steps(value, min, max, step) ? defect("no whole number of steps above", min) : "";
}

}  // namespace

Check check_ranges(const Claim& claim) {
    std::vector<std::string> defects;
    for (std::size_t i = 0; i < claim.design.size(); ++i)
        if (std::string defect = dimension_defect(claim, i); !defect.empty()) defects.push_back(std::move(defect));
    return {"dimensions are as given and within their ranges", defects.empty(),
            defects.empty() ? fmt::format("all {} dimensions", claim.design.size())
                            : fmt::format("{}", fmt::join(defects, "; "))};
}

Check check_kind(const Rebuilt& design) {
    const std::string kind = design.claim->mechanism->describe(design.claim->mechanism->form(0), design.rounded);
    const std::string& stated = *design.claim->kind;
    return {
        "is the kind of mechanism that is stated", kind == stated,
        kind == stated ? kind : fmt::format("stated is {}, it is {}", reading::quoted(stated), reading::quoted(kind))};
}

Check check_circuit(const Rebuilt& design) {
    const Mechanism& mechanism = *design.claim->mechanism;
    const CircuitAndBranch stated = *design.claim->circuit;
    CircuitAndBranch found{0, 0};
    if (mechanism.circuit) found = mechanism.circuit(design.motion, design.rounded).value_or(found);
    const auto words = [](const CircuitAndBranch& c) {
        return c.circuit == 0 ? "no branch that has a number"
                              : fmt::format("branch {} of circuit {}", c.branch, c.circuit);
    };
    const bool alike = found.circuit == stated.circuit && found.branch == stated.branch;
    return {"moves on the circuit and the branch that are stated", alike,
            alike ? words(stated) : fmt::format("stated is {}, it is {}", words(stated), words(found))};
}

bool ends_by_itself(const Rebuilt& design) {
    const Claim& claim = *design.claim;
    const Motion& motion = design.motion;
    return !claim.crank_range && !claim.use && input_tasks(claim).empty() && !motion.full_turn &&
           motion.from <= motion.to;
}

Check check_whole_motion(const Rebuilt& design) {
    // Where next to a change point the two ends are this close to each other, the loop fails to close between them by
    // less than the check of the motion allows for rounding, for that grows with the square of the angle.
    constexpr double closed_but_for_rounding = 1e-5;  // radians
    const Unit unit = input_unit(*design.claim->mechanism);
    const double far = std::max(std::abs(design.motion.from), std::abs(design.motion.to));
    const double little = 1e-6 * (unit == Unit::angle ? 1 : far);  // radians, or of the displacement
    const double gap = cycle_of(*design.claim->mechanism) - (design.motion.to - design.motion.from);
    if (unit == Unit::angle && gap >= 0 && gap < closed_but_for_rounding)
        return {"moves as far as it can", true, "all but a full turn: between the ends it comes apart by rounding"};
    Check check{"moves as far as it can", true, "beyond both ends of its motion it comes apart"};
    for (const double sign : {-1.0, 1.0}) {
        Motion longer = design.motion;
        (sign < 0 ? longer.from : longer.to) += sign * little;
        if (!all_passed(design.claim->mechanism->check_motion(longer, design.dimensions))) continue;
        const double end = sign < 0 ? design.motion.from : design.motion.to;
        check = {check.name, false,
                 fmt::format("it goes on beyond {} {}", input_word(*design.claim->mechanism),
                             value_text(end, unit, design.claim->units))};
    }
    return check;
}

}  // namespace mechwright
