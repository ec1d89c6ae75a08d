#include "synthesis/solve/ranked.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/methods.h"
#include "synthesis/solve/parts.h"

namespace mechwright {

namespace {

double longest_dimension(const Problem& problem, const Design& design) {
    double longest = 0;
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (scales(problem.mechanism->dimensions[i].kind)) longest = std::max(longest, std::abs(design.dimensions[i]));
    return longest;
}

/// What is allowed where a design is the best that was found.
MetWish met(const Problem& problem, const Wish& wish, const Design& best) {
    const Unit unit = problem.mechanism->quantities[wish.term.quantity].unit;
    const double value = *quantity_value(problem, wish.term.quantity, best);
    const double longest = longest_dimension(problem, best);
    const double size = unit == Unit::length ? longest : unit == Unit::curvature ? 1 / longest : 1;
    const double room = std::max({wish.within, 1e-6 * std::abs(value), 1e-9 * size});
    return {value, wish.term.maximize ? value - room : value + room};
}

/// The first feasible candidate that passes verification; null where none does.
const Solution* first_verified(const Problem& problem, const Found& found, const RunEnd& end) {
    for (std::size_t i = 0; i < std::min(found.most_tried, found.candidates.size()); ++i) {
        if (!found.candidates[i].feasible || (i > 0 && end.reached())) break;
        if (all_passed(checks_of(problem, found.candidates[i]))) return &found.candidates[i];
    }
    return nullptr;
}

}  // namespace

Found ranked_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    Problem stage = problem;
    stage.wishes.clear();
    stage.text.clear();  // which asks for something else
    SearchReport before;
    std::vector<MetWish> wished;
    std::optional<Design> best;
    for (const Wish& wish : problem.wishes) {
        stage.objective = Objective{{wish.term}, false};
        Found found = find_designs(stage, options, end);
        const Solution* first = first_verified(stage, found, end);
        if (first == nullptr) {  // what has no design, or none in time, is told of the problem itself
            for (Solution& candidate : found.candidates)
                candidate = assess(problem, std::move(candidate.design));
            if (!found.infeasible) found.report.proof = nullptr;
            add_work(found.report, before);
            return found;
        }
        add_work(before, found.report);
        best = first->design;
        wished.push_back(met(stage, wish, *best));
        Requirement limit{wish.term.quantity, {}, {}, {}};
        (wish.term.maximize ? limit.min : limit.max) = wished.back().limit;
        stage.requirements.push_back(limit);
        begin_at(stage, *best);
    }
    stage.objective = problem.objective;
    Found found = find_designs(stage, options, end);
    found.report.proof = nullptr;  // it is of the limits that were found
    found.infeasible = false;
    found.checks_of_first.clear();
    add_work(found.report, before);
    found.candidates.push_back(assess(stage, *best));
    std::stable_sort(found.candidates.begin(), found.candidates.end(),
                     [&](const Solution& a, const Solution& b) { return preferred(stage, a, b); });
    for (Solution& candidate : found.candidates)
        candidate.wished = wished;
    return found;
}

}  // namespace mechwright
