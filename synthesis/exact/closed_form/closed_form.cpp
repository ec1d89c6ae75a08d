#include "synthesis/exact/closed_form/closed_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace mechwright {

namespace {

const std::array<ClosedForm, 8>& closed_forms() {
    static const std::array<ClosedForm, 8> all{crank_rocker_closed_form(),    slider_crank_closed_form(),
                                               crank_shaper_closed_form(),    whitworth_closed_form(),
                                               translating_cam_closed_form(), oscillating_cam_closed_form(),
                                               flat_cam_closed_form(),        swinging_flat_cam_closed_form()};
    return all;
}

/// Whether the dimensions meet the linear conditions of a family, to rounding.
bool is_mechanism(const Mechanism& mechanism, const Design& design) {
    constexpr double met_within = 1e-9;
    const auto meets = [&](const LinearCondition& condition) {
        double sum = 0, size = 0;
        for (std::size_t i = 0; i < condition.coefficients.size(); ++i) {
            sum += condition.coefficients[i] * design.dimensions[i];
            size += std::abs(condition.coefficients[i] * design.dimensions[i]);
        }
        return sum >= -met_within * size;
    };
    return std::any_of(mechanism.families.begin(), mechanism.families.end(), [&](const Family& family) {
        return std::all_of(family.conditions.begin(), family.conditions.end(), meets);
    });
}

}  // namespace

void keep_smaller(std::optional<ClosedFormOutcome>& best, ClosedFormOutcome outcome) {
    const auto order = [](const ClosedFormOutcome& one) {
        return std::tuple(one.infeasible, one.infeasible ? one.least : one.best->objective,
                          one.infeasible ? one.best->violation : 0);
    };
    if (!best || order(outcome) < order(*best)) best = std::move(outcome);
}

std::string why_no_closed_form(const Problem& problem) {
    if (has_ties(problem)) return "closed forms do not know dimensions that are tied to others";
    std::string known;
    for (const ClosedForm& form : closed_forms()) {
        if (form.covers(problem)) return {};
        if (!form.good_for.empty()) known += (known.empty() ? "" : "; ") + std::string(form.good_for);
    }
    return "closed forms are known for " + known;
}

std::optional<ClosedFormOutcome> solve_in_closed_form(const Problem& problem) {
    if (has_ties(problem)) return std::nullopt;
    for (const ClosedForm& form : closed_forms()) {
        if (!form.covers(problem)) continue;
        auto outcome = form.solve(problem);
        // Beyond its ranges the smallest design need not be a mechanism at all: then there is none to show.
        if (outcome && outcome->infeasible && outcome->best && !is_mechanism(*problem.mechanism, outcome->best->design))
            outcome->best.reset();
        return outcome;
    }
    return std::nullopt;
}

}  // namespace mechwright
