#include "synthesis/program/assess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "synthesis/problem/units.h"
#include "synthesis/program/nearest_point.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/standing.h"

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
        const bool length = problem.mechanism->dimensions[i].kind == DimensionKind::length;
        if (!std::isfinite(value) || (length && !(value > 0))) return without_limit;
    }
    return worst;
}

/// Points that the mechanism cannot reach assembled, untimed points out of order, and a crank that does not go round a
/// closed path.
double path_violation(const Problem& problem, const Design& design) {
    if (!problem.path) return 0;
    const Motion whole = problem.mechanism->motion(design.dimensions, design.assembly, nullptr);
    if (problem.path->closed && !whole.full_turn) return without_limit;
    double worst = 0;
    for (std::size_t i = 0; i < design.path_angles.size(); ++i) {
        PathMiss miss{};
        problem.mechanism->path_miss(design.assembly, design.dimensions, design.path_angles[i], problem.path->points[i],
                                     miss);
        if (!(miss.margin >= 0)) return without_limit;
    }
    if (problem.path->prescribed_timing || problem.path->any_order || design.path_angles.size() < 3) return worst;
    const double direction = design.path_angles.back() > design.path_angles.front() ? 1 : -1;
    for (std::size_t i = 1; i < design.path_angles.size(); ++i)
        worst = std::max(worst, -direction * (design.path_angles[i] - design.path_angles[i - 1]));
    const double turn = std::abs(design.path_angles.back() - design.path_angles.front());
    return std::max(worst, turn - 2 * std::numbers::pi);
}

/// Of cams: a follower that is not held, and an undercut, relative to the radius of the cam. Linkages are judged by the
/// quantities that have a value.
double existence_violation(const Problem& problem, const Design& design) {
    if (!problem.program) return 0;
    const Quantity& margin = *problem.mechanism->families[0].assembly_margin;
    const Motion motion = motion_of(problem, design);
    std::array<double, Quantity::most_components> components{};
    Measurement measurement;
    measurement.value = components;
    margin.measure(motion, design.dimensions, measurement);
    double worst = 0;
    for (std::size_t i = 0; i < margin.components(motion); ++i) {
        const double missed = -components[i] / design.dimensions[0];
        worst = std::max(worst, std::isnan(missed) ? without_limit : missed);
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
    s.violation = std::max(
        {range_violation(problem, design), path_violation(problem, design), existence_violation(problem, design)});
    double on_equalities = s.violation;
    for (const Requirement& r : problem.requirements) {
        const double missed = standing_of(problem, r, design).violation.value_or(without_limit);
        s.violation = std::max(s.violation, missed);
        if (r.equal) on_equalities = std::max(on_equalities, missed);
    }
    if (std::isnan(s.objective) || !assembles_over_range(problem, design)) s.violation = without_limit;
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

}  // namespace mechwright
