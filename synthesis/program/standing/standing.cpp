#include "synthesis/program/standing/standing.h"

#include <algorithm>
#include <cmath>

#include "synthesis/program/quantity_value.h"

namespace mechwright {

namespace {

constexpr double active_within = 1e-6;
/// Room for rounding between this evaluation and the one that called a design feasible.
constexpr double rounding_room = 1 + 1e-3;

double scale_of(const Problem& problem, const Requirement& requirement, const Design& design) {
    const double greatest = std::max({std::abs(requirement.equal.value_or(0)), std::abs(requirement.min.value_or(0)),
                                      std::abs(requirement.max.value_or(0))});
    if (greatest > 0) return greatest;
    const Unit unit = problem.mechanism->quantities[requirement.quantity].unit;
    const double length = longest_length(*problem.mechanism, design.dimensions);
    const double longest = length > 0 ? length : 1;
    switch (unit) {
        case Unit::length: return longest;
        case Unit::area: return longest * longest;
        case Unit::curvature: return 1 / longest;
        default: return 1;
    }
}

}  // namespace

bool is_active(double shortfall, const Standing& standing) { return shortfall >= -active_within * standing.scale; }

Standing standing_of(const Problem& problem, const Requirement& requirement, const Design& design) {
    Standing standing;
    standing.value = quantity_value(problem, requirement.quantity, design);
    standing.scale = scale_of(problem, requirement, design);
    standing.allowed = rounding_room * problem.solver.tolerance * standing.scale;
    standing.active = requirement.equal.has_value();
    if (!standing.value) return standing;

    const double value = *standing.value;
    double violation = 0;
    const auto hold_to = [&](double shortfall) {
        violation = std::max(violation, shortfall / standing.scale);
        standing.active = standing.active || is_active(shortfall, standing);
    };
    if (requirement.equal) hold_to(std::abs(value - *requirement.equal));
    if (requirement.min) hold_to(*requirement.min - value);
    if (requirement.max) hold_to(value - *requirement.max);
    standing.violation = violation;
    return standing;
}

}  // namespace mechwright
