#include "synthesis/bench/known_optimum.h"

#include <algorithm>
#include <cmath>

#include "synthesis/local/local.h"

namespace mechwright::bench {

namespace {

/// An objective below this is zero, and what it holds is rounding.
constexpr double zero_below = 1e-10;
/// Programs in which a design violates more than this are not those that it lies in.
constexpr double of_this_variant = 1e-6;

std::optional<LocalOutcome> polished_in(const Program& program, const Design& design) {
    LocalOutcome outcome;
    Eigen::VectorXd x = point_of(program, design);
    settle_epigraphs(program, x);
    ProgramValues values;
    evaluate(program, x, false, values);
    if (!values.assembled || violation(program, x, values) > of_this_variant) return std::nullopt;
    outcome.consider(program, x, values);
    return polish(program, outcome, {});
}

}  // namespace

std::optional<KnownOptimum> optimum_at(const Problem& problem, const Design& design) {
    std::optional<KnownOptimum> best;
    for (const Variant& variant : variants(problem)) {
        if (variant.assembly != design.assembly) continue;
        Program program = build_program(problem, variant);
        const auto outcome = polished_in(program, design);
        if (!outcome || outcome->violation > LocalOutcome::feasible_below) continue;
        if (!best || outcome->objective < best->objective)
            best = KnownOptimum{std::move(program), outcome->x, outcome->objective};
    }
    return best;
}

std::optional<KnownOptimum> known_optimum(const Problem& problem, const RunOptions& options) {
    const Result result = solve(problem, options);
    if (result.status != Status::solved || !problem.objective) return std::nullopt;
    return optimum_at(problem, result.best->design);
}

double error_of(double objective, double violation, double known) {
    const double size = std::abs(known) < zero_below ? 1 : std::abs(known);
    return std::max(std::abs(objective - known) / size, violation);
}

}  // namespace mechwright::bench
