#include "synthesis/document/claimed_problem.h"

#include <fmt/format.h>

#include <limits>

#include "synthesis/mechanism/input.h"
#include "synthesis/problem/units.h"

namespace mechwright {

namespace {

/// Crank angles in radians, or displacements.
std::vector<double> inputs(const std::vector<double>& stated, const Claim& claim) {
    std::vector<double> all;
    for (const double input : stated)
        all.push_back(from_file_unit(input, input_unit(*claim.mechanism), claim.units));
    return all;
}

DimensionRange range_of(const Claim& claim, std::size_t dimension) {
    const std::optional<ClaimedRange>& given = claim.given[dimension];
    DimensionRange range;
    if (!given) return range;
    const Unit unit = unit_of(claim.mechanism->dimensions[dimension].kind);
    range.named = true;
    range.tie = given->tie;
    range.tie.constant = from_file_unit(given->tie.constant, unit, claim.units);
    range.min = from_file_unit(given->min, unit, claim.units);
    range.max = from_file_unit(given->max, unit, claim.units);
    for (const double choice : given->choices)
        range.choices.push_back(from_file_unit(choice, unit, claim.units));
    range.step = from_file_unit(given->step, unit, claim.units);
    // A tied dimension has no limits of its own.
    if (range.tied()) range.min = range.max = from_file_unit(claim.design[dimension], unit, claim.units);
    return range;
}

std::vector<Requirement> requirements_of(const Claim& claim) {
    std::vector<Requirement> requirements;
    for (const ClaimedRequirement& r : claim.requirements) {
        const Unit unit = claim.mechanism->quantities[r.quantity].unit;
        const auto inside = [&](const std::optional<double>& limit) {
            return limit ? std::optional(from_file_unit(*limit, unit, claim.units)) : std::nullopt;
        };
        requirements.push_back({r.quantity, inside(r.equal), inside(r.min), inside(r.max)});
    }
    return requirements;
}

std::optional<Objective> objective_of(const Claim& claim) {
    if (!claim.objective) return std::nullopt;
    Objective objective{{}, claim.objective->worst};
    for (const ClaimedTerm& term : claim.objective->terms)
        objective.terms.push_back({term.quantity, term.maximize, term.weight});
    return objective;
}

std::optional<PathTarget> path_of(const Claim& claim) {
    if (!claim.path) return std::nullopt;
    const ClaimedPath& path = *claim.path;
    PathTarget target{path.points,
                      path.prescribed_timing,
                      path.any_order,
                      inputs(path.prescribed_angles, claim),
                      path.closed,
                      path.weights,
                      {},
                      path.body_length};
    for (const std::optional<double>& direction : path.directions)
        target.directions.push_back(direction ? from_file_unit(*direction, Unit::angle, claim.units)
                                              : std::numeric_limits<double>::quiet_NaN());
    target.parts = path.parts;
    target.part_of = path.part_of;
    return target;
}

}  // namespace

ClaimedDesign claimed_design(const Claim& claim) {
    ClaimedDesign claimed;
    Problem& problem = claimed.problem;
    problem.mechanism = claim.mechanism;
    problem.units = claim.units;
    problem.assemblies = {claim.assembly};
    problem.requirements = requirements_of(claim);
    for (const ClaimedWish& wish : claim.wishes) {
        const Unit unit = claim.mechanism->quantities[wish.quantity].unit;
        problem.wishes.push_back({{wish.quantity, wish.maximize, 1}, from_file_unit(wish.within, unit, claim.units)});
    }
    problem.objective = objective_of(claim);
    problem.path = path_of(claim);
    problem.settings = claim.settings;
    problem.function = claim.function;
    problem.followed = claim.followed;
    problem.over_input = claim.over_input;
    problem.has_instant = claim.has_instant;
    problem.solver.tolerance = claim.tolerance;
    if (claim.crank_range)
        problem.crank_range =
            Vector<double>{from_file_unit(claim.crank_range->x, input_unit(*claim.mechanism), claim.units),
                           from_file_unit(claim.crank_range->y, input_unit(*claim.mechanism), claim.units)};
    const auto inside = [&](double input) { return from_file_unit(input, input_unit(*claim.mechanism), claim.units); };
    if (claim.use) problem.use = RangeOfUse{inside(claim.use->before), inside(claim.use->after)};
    for (std::size_t i = 0; i < claim.design.size(); ++i) {
        problem.dimensions.push_back(range_of(claim, i));
        const Unit unit = unit_of(claim.mechanism->dimensions[i].kind);
        claimed.design.dimensions.push_back(from_file_unit(claim.design[i], unit, claim.units));
    }
    claimed.design.assembly = claim.assembly;
    if (claim.path && claim.path->crank_angles.size() == claim.path->points.size())
        claimed.design.path_angles = inputs(claim.path->crank_angles, claim);
    return claimed;
}

std::string why_not_evaluable(const Claim& claim) {
    for (std::size_t i = 0; i < claim.design.size(); ++i) {
        const Dimension& dimension = claim.mechanism->dimensions[i];
        if (dimension.kind == DimensionKind::length && !(claim.design[i] > 0))
            return fmt::format("design.{} is {}, and a length has to be greater than 0", dimension.name,
                               claim.design[i]);
    }
    return {};
}

}  // namespace mechwright
