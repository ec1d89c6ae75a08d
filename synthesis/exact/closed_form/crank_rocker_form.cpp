#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "analysis/four_bar.h"
#include "analysis/four_bar/best_crank_rocker.h"
#include "synthesis/exact/closed_form/closed_form.h"
#include "synthesis/exact/family_size.h"
#include "synthesis/mechanism/four_bar/formulas.h"
#include "synthesis/program/assess.h"
#include "synthesis/proof/known_limits.h"

namespace mechwright {

namespace {

constexpr std::size_t links = four_bar::links;

/// What the closed form of the crank-rocker is asked.
struct CrankRockerTask {
    double swing = 0;
    double time_ratio = 0;
    std::optional<double> least_transmission;  ///< required
};

/// The task a problem poses, or nothing if it asks for anything else.
std::optional<CrankRockerTask> crank_rocker_task(const Problem& problem) {
    if (problem.path || problem.crank_range) return std::nullopt;
    CrankRockerTask task;
    for (const Requirement& r : problem.requirements) {
        const Quantity& q = problem.mechanism->quantities[r.quantity];
        if (is_measured_by<four_bar::Swing>(q) && r.equal && task.swing == 0)
            task.swing = *r.equal;
        else if (is_measured_by<four_bar::TimeRatio>(q) && r.equal && task.time_ratio == 0)
            task.time_ratio = *r.equal;
        else if (is_measured_by<four_bar::TransmissionAngleWorst>(q) && r.min && !r.max && !task.least_transmission)
            task.least_transmission = *r.min;
        else
            return std::nullopt;
    }
    if (problem.objective) {
        const Objective& objective = *problem.objective;
        if (objective.terms.size() != 1 || !objective.terms.front().maximize) return std::nullopt;
        const Quantity& q = problem.mechanism->quantities[objective.terms.front().quantity];
        if (!is_measured_by<four_bar::TransmissionAngleWorst>(q)) return std::nullopt;
    }
    const bool makes_sense = task.swing > 0 && task.swing < std::numbers::pi && task.time_ratio > 1;
    return makes_sense ? std::optional(task) : std::nullopt;
}

double worst_transmission(const FourBar<double>& m) {
    const double least = transmission_angle(m, HalfTurn<double>{1, 0});
    const double greatest = transmission_angle(m, HalfTurn<double>{0, 1});
    return std::min(least, std::numbers::pi - greatest);
}

/// The linkage at a size at which all its links lie in their ranges.
std::optional<FourBar<double>> sized(const Problem& problem, const FourBar<double>& m) {
    const std::array<UnitDimension, links> dimensions{{{0, m.ground}, {1, m.crank}, {2, m.coupler}, {3, m.rocker}}};
    const auto size = size_in_ranges(problem, dimensions);
    if (!size) return std::nullopt;
    return FourBar<double>{*size * m.ground, *size * m.crank, *size * m.coupler, *size * m.rocker};
}

Design design_of(const Problem& problem, const FourBar<double>& m) {
    Design design;
    const std::array<double, links> length{m.ground, m.crank, m.coupler, m.rocker};
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        const DimensionRange& range = problem.dimensions[i];
        const double middle = range.start.value_or(0.5 * (range.min + range.max));
        design.dimensions.push_back(range.fixed() ? range.min : i < links ? length[i] : middle);
    }
    design.assembly = problem.assemblies.front();
    return design;
}

/// By how many families of crank-rockers a swing and a time ratio can be met.
std::string argument_for(int families) {
    switch (families) {
        case 1:
            return "closed form: all crank-rockers of this swing and time ratio form one one-parameter family; this is "
                   "its optimum";
        default:
            return "closed form: all crank-rockers of this swing and time ratio form two one-parameter families, one "
                   "for each direction of the crank; this is the better of their two optima";
    }
}

bool covers(const Problem& problem) { return crank_rocker_task(problem).has_value(); }

std::optional<ClosedFormOutcome> solve(const Problem& problem) {
    const auto task = crank_rocker_task(problem);
    if (!task) return std::nullopt;
    const double slow_stroke = 2 * std::numbers::pi * task->time_ratio / (1 + task->time_ratio);
    ClosedFormOutcome outcome;
    std::optional<FourBar<double>> best;
    double unknown_below = 0;  // how good members of a family without an optimum can be at most
    int families = 0;
    for (const double forward_stroke : {slow_stroke, 2 * std::numbers::pi - slow_stroke}) {
        const double bound = transmission_bound_of_crank_rockers(task->swing, forward_stroke);
        if (bound <= 0) continue;
        ++families;
        const auto of_family = best_transmission_crank_rocker(task->swing, forward_stroke);
        if (!of_family)
            unknown_below = std::max(unknown_below, bound);
        else if (!best || worst_transmission(*of_family) > worst_transmission(*best))
            best = of_family;
    }
    if (families > 0 && (!best || worst_transmission(*best) < unknown_below)) return std::nullopt;
    outcome.infeasible = families == 0;
    if (outcome.infeasible) {
        outcome.proof = proof_by_limits(problem);
        return outcome.proof ? std::optional(outcome) : std::nullopt;
    }
    const FourBar<double>& better = *best;
    outcome.infeasible =
        task->least_transmission && worst_transmission(better) < *task->least_transmission - problem.solver.tolerance;
    // The bound holds at any size; where the ranges exclude its linkage, it is shown at the size of the first range.
    auto linkage = sized(problem, better);
    if (!linkage && !outcome.infeasible) return std::nullopt;
    if (!linkage) {
        const double ground = problem.dimensions[0].max;
        linkage = FourBar<double>{ground, ground * better.crank, ground * better.coupler, ground * better.rocker};
    }
    outcome.best = assess(problem, design_of(problem, *linkage));
    if (!outcome.infeasible && !outcome.best->feasible) return std::nullopt;
    const auto quantity = static_cast<std::size_t>(find_quantity(*problem.mechanism, "transmission-angle-worst"));
    if (outcome.infeasible || problem.objective)
        outcome.proof =
            proof_by(argument_for(families), LimitCertificate{"family", quantity, worst_transmission(better)});
    else
        outcome.proof = proof_by(argument_for(families), GivenCertificate{});
    return outcome;
}

}  // namespace

ClosedForm crank_rocker_closed_form() {
    return {covers, solve,
            "crank-rockers with swing and time ratio (> 1) required as equalities and, if anything more, the greatest "
            "transmission-angle-worst"};
}

}  // namespace mechwright
