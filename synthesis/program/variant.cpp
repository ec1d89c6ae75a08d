#include "synthesis/program/variant.h"

#include <algorithm>
#include <numbers>

#include "synthesis/mechanism/cycle.h"
#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/choices.h"

namespace mechwright {

bool is_disjunctive(const Quantity& quantity, const Requirement& requirement) {
    if (quantity.reduce == Reduce::only || quantity.worst_first) return false;
    return requirement.equal || (quantity.reduce == Reduce::least ? requirement.max : requirement.min);
}

bool is_disjunctive(const Quantity& quantity, const ObjectiveTerm& term) {
    if (quantity.reduce == Reduce::only || quantity.worst_first) return false;
    return (quantity.reduce == Reduce::least) != term.maximize;
}

std::vector<Disjunction> disjunctions(const Problem& problem, const Motion& motion) {
    std::vector<Disjunction> all;
    const auto add = [&](std::size_t index, const auto& condition, bool required) {
        const Quantity& quantity = programmed_quantity(problem, index);
        if (quantity.path != PathMeasure::none || !is_disjunctive(quantity, condition)) return;
        const std::size_t components = quantity.components(motion_of(problem, quantity, motion));
        if (components > 1) all.push_back({index, components, required});
    };
    for (const Requirement& r : problem.requirements)
        add(r.quantity, r, true);
    if (problem.objective)
        for (const ObjectiveTerm& t : problem.objective->terms)
            add(t.quantity, t, false);
    return all;
}

bool all_defined(const Problem& problem, const Motion& motion) {
    const auto defined = [&](std::size_t index) { return has_value(problem, index, motion); };
    return std::all_of(problem.requirements.begin(), problem.requirements.end(),
                       [&](const Requirement& r) { return defined(r.quantity); }) &&
           (!problem.objective || std::all_of(problem.objective->terms.begin(), problem.objective->terms.end(),
                                              [&](const ObjectiveTerm& t) { return defined(t.quantity); }));
}

namespace {

/// Whether a problem names a quantity that is measured over the motion. Where it does and gives no range, the motion of
/// a crank that does not turn fully ends at toggles, and there is nothing to design.
std::vector<std::size_t> families_of(const Problem& problem) {
    const auto& families = problem.mechanism->families;
    std::vector<std::size_t> usable;
    for (std::size_t f = 0; f < families.size(); ++f) {
        const Motion motion = motion_of(problem, f, 0);
        const bool range_known =
            families[f].full_turn || problem.crank_range || problem.path || has_input_range(problem);
        if (!may_have_family(problem, f)) continue;
        if (problem.path && problem.path->closed && !families[f].full_turn) continue;
        if (range_known && all_defined(problem, motion)) usable.push_back(f);
    }
    // Over a given range the family of limited motions contains all others.
    if (problem.crank_range && !moves_over_targets(problem))
        for (const std::size_t f : usable)
            if (!families[f].full_turn) return {f};
    return usable;
}

/// Whether it makes a difference which way the crank turns, or the slide goes.
bool has_directions(const Problem& problem) {
    const PathTarget& path = *problem.path;
    for (std::size_t target = 0; target < path.targets(); ++target)
        if (path.points_of(target).count >= least_ordered(*problem.mechanism)) return true;
    return false;
}

}  // namespace

std::vector<Variant> variants(const Problem& problem) {
    std::vector<Variant> all;
    const bool untimed = problem.path && !problem.path->prescribed_timing && has_directions(problem);
    for (const std::size_t family : families_of(problem))
        for (const std::size_t assembly : problem.assemblies)
            for (const int direction : untimed ? std::vector<int>{1, -1} : std::vector<int>{1})
                for (auto& choice : choices_of_components(problem, family, assembly))
                    all.push_back({family, assembly, direction, std::move(choice)});
    return all;
}

std::string name_of(const Problem& problem, const Variant& variant) {
    std::string name(problem.mechanism->families[variant.family].name);
    if (problem.mechanism->assemblies.size() > 1) {
        name += ", ";
        name += problem.mechanism->assemblies[variant.assembly];
    }
    return name;
}

}  // namespace mechwright
