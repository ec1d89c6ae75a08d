#include "synthesis/program/assess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "synthesis/problem/allowed_values.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/standing/standing.h"
#include "synthesis/program/standing/validity.h"
#include "synthesis/target/path/rows/nearest_point.h"

namespace mechwright {

namespace {

constexpr double without_limit = std::numeric_limits<double>::infinity();

double range_violation(const Problem& problem, const Design& design) {
    double worst = 0;
    for (std::size_t i = 0; i < design.dimensions.size(); ++i) {
        const DimensionRange& range = problem.dimensions[i];
        const double value = design.dimensions[i];
        const double size = std::max({std::abs(range.min), std::abs(range.max), std::numeric_limits<double>::min()});
        worst = std::max({worst, (range.min - value) / size, (value - range.max) / size});
        if (range.discrete()) worst = std::max(worst, std::abs(value - nearest_allowed(range, value)) / size);
        const bool length = problem.mechanism->dimensions[i].kind == DimensionKind::length;
        if (!std::isfinite(value) || (length && !(value > 0))) return without_limit;
    }
    return worst;
}

/// What makes the design useless: by how much it misses where that is tolerated, else without limit.
double validity_violation(const Problem& problem, const Design& design) {
    double worst = 0;
    for (const ValidityMargin& m : validity_margins(problem, design)) {
        if (m.margin >= 0) continue;
        worst = std::max(worst, m.tolerated ? -m.margin : without_limit);
    }
    return worst;
}

/// The objective in the file's units; NaN where a term has no value.
double objective_of(const Problem& problem, const Design& design) {
    if (!problem.objective) return 0;
    const Objective& objective = *problem.objective;
    const auto value_of = [&](const ObjectiveTerm& term) {
        const auto value = quantity_value(problem, term.quantity, design);
        return value ? in_file_unit(*value, problem.mechanism->quantities[term.quantity].unit, problem.units)
                     : std::numeric_limits<double>::quiet_NaN();
    };
    if (objective.terms.size() == 1) return value_of(objective.terms.front());
    double total = objective.worst ? (maximizes(problem) ? without_limit : -without_limit) : 0;
    for (const ObjectiveTerm& term : objective.terms) {
        const double value = term.weight * value_of(term);
        if (std::isnan(value)) return value;
        if (!objective.worst)
            total += term.maximize ? -value : value;
        else
            total = term.maximize ? std::min(total, value) : std::max(total, value);
    }
    return total;
}

}  // namespace

Solution assess(const Problem& problem, Design design) {
    Solution s;
    if (problem.path && problem.path->any_order) meet_nearest_points(problem, design);
    s.objective = objective_of(problem, design);
    s.violation = std::max(range_violation(problem, design), validity_violation(problem, design));
    double on_equalities = s.violation;
    for (const Requirement& r : problem.requirements) {
        const double missed = standing_of(problem, r, design).violation.value_or(without_limit);
        s.violation = std::max(s.violation, missed);
        if (r.equal) on_equalities = std::max(on_equalities, missed);
    }
    if (std::isnan(s.objective)) s.violation = without_limit;
    s.misses_inequalities_only = on_equalities <= problem.solver.tolerance && s.violation < without_limit;
    s.feasible = s.violation <= problem.solver.tolerance;
    s.design = std::move(design);
    return s;
}

bool maximizes(const Problem& problem) {
    return problem.objective && (problem.objective->terms.size() == 1 || problem.objective->worst) &&
           problem.objective->terms.front().maximize;
}

bool preferred(const Problem& problem, const Solution& a, const Solution& b) {
    if (a.feasible != b.feasible) return a.feasible;
    if (!a.feasible && a.misses_inequalities_only != b.misses_inequalities_only) return a.misses_inequalities_only;
    if (!a.feasible && a.violation != b.violation) return a.violation < b.violation;
    return maximizes(problem) ? a.objective > b.objective : a.objective < b.objective;
}

Solution evaluate_given(const Problem& problem) { return evaluate_given(problem, problem.assemblies.front()); }

Solution evaluate_given(const Problem& problem, std::size_t assembly) {
    Design design;
    for (const DimensionRange& d : problem.dimensions)
        design.dimensions.push_back(d.min);
    design.assembly = assembly;
    if (problem.path && problem.path->prescribed_timing) set_prescribed_angles(problem, design);
    return assess(problem, std::move(design));
}

}  // namespace mechwright
