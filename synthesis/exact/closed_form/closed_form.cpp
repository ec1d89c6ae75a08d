#include "synthesis/exact/closed_form/closed_form.h"

#include <array>

namespace mechwright {

namespace {

const std::array<ClosedForm, 8>& closed_forms() {
    static const std::array<ClosedForm, 8> all{crank_rocker_closed_form(),    slider_crank_closed_form(),
                                               crank_shaper_closed_form(),    whitworth_closed_form(),
                                               translating_cam_closed_form(), oscillating_cam_closed_form(),
                                               flat_cam_closed_form(),        swinging_flat_cam_closed_form()};
    return all;
}

}  // namespace

void keep_smaller(std::optional<ClosedFormOutcome>& best, ClosedFormOutcome outcome) {
    const bool better = !best || (best->infeasible && !outcome.infeasible) ||
                        (best->infeasible == outcome.infeasible && outcome.best->objective < best->best->objective);
    if (better) best = std::move(outcome);
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
    for (const ClosedForm& form : closed_forms())
        if (form.covers(problem)) return form.solve(problem);
    return std::nullopt;
}

}  // namespace mechwright
