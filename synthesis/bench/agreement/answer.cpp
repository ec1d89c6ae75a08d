#include "synthesis/bench/agreement/answer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "synthesis/bench/known_optimum.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/search/polished_search.h"

namespace mechwright::bench {

namespace {

/// A number below this part of its scale is zero, and what it holds is rounding.
constexpr double zero_below = 1e-10;

double longest_dimension(const Problem& problem, const Design& design) {
    double longest = 0;
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (problem.mechanism->dimensions[i].kind == DimensionKind::length)
            longest = std::max(longest, std::abs(design.dimensions[i]));
    return longest > 0 ? longest : 1;
}

/// What counts as one in a unit: a design's longest dimension, one radian.
double scale_of(const Problem& problem, const Design& design, Unit unit) {
    const double length = longest_dimension(problem, design);
    switch (unit) {
        case Unit::length:
        case Unit::force: return length;
        case Unit::area:
        case Unit::torque: return length * length;
        case Unit::curvature: return 1 / length;
        case Unit::angle: return file_units_per_inner(unit, problem.units);
        default: return 1;
    }
}

Unit unit_of(const Problem& problem, const ObjectiveTerm& term) {
    return problem.mechanism->quantities[term.quantity].unit;
}

void add_objective(Answer& answer, const Problem& problem) {
    const Solution& best = *answer.result.best;
    double scale = 0;
    for (const ObjectiveTerm& term : problem.objective->terms)
        scale = std::max(scale, term.weight * scale_of(problem, best.design, unit_of(problem, term)));
    answer.numbers.push_back(best.objective);
    answer.scales.push_back(scale);
}

/// The best value of each of the two objectives.
void add_ends(Answer& answer, const Problem& problem) {
    for (std::size_t k = 0; k < 2; ++k) {
        const ObjectiveTerm& term = problem.objective->terms[k];
        const Design& design = (k == 0 ? answer.result.front.front() : answer.result.front.back()).solution.design;
        const auto value = quantity_value(problem, term.quantity, design);
        answer.numbers.push_back(value ? in_file_unit(*value, unit_of(problem, term), problem.units) : std::nan(""));
        answer.scales.push_back(scale_of(problem, design, unit_of(problem, term)));
    }
}

AnswerKind kind_of(const Problem& problem, const Result& result) {
    if (!result.best) return AnswerKind::none;
    if (result.status == Status::infeasible) return AnswerKind::infeasible;
    if (!problem.objective) return AnswerKind::design;
    return result.front.empty() ? AnswerKind::optimum : AnswerKind::trade_off;
}

bool only_by_search(const Problem& problem) { return !problem.path && !problem.function && !problem.has_instant; }

/// Whether the objective is how far the targets are missed: then what meets them exactly is best.
bool asks_for_least_miss(const Problem& problem) {
    return problem.path && problem.objective && problem.objective->terms.size() == 1 &&
           problem.mechanism->quantities[problem.objective->terms.front().quantity].path != PathMeasure::none;
}

/// Whether the exact method and the searches answer the same question: it has all targets met, they look for the best
/// objective whatever the targets.
bool exact_is_comparable(const Problem& problem) { return only_by_search(problem) || asks_for_least_miss(problem); }

}  // namespace

Answer answer_of(Problem problem, std::string_view method, const RunOptions& options) {
    problem.solver.method = method;
    Answer answer;
    answer.result = solve(problem, options);
    answer.kind = kind_of(problem, answer.result);
    answer.method = answer.result.search.method.empty() ? std::string(method) : answer.result.search.method;
    switch (answer.kind) {
        case AnswerKind::optimum: add_objective(answer, problem); break;
        case AnswerKind::trade_off: add_ends(answer, problem); break;
        case AnswerKind::infeasible:
            answer.numbers.push_back(answer.result.best->violation);
            answer.scales.push_back(1);
            break;
        default: break;
    }
    return answer;
}

double difference(const Answer& a, const Answer& b) {
    if (a.kind != b.kind || a.numbers.size() != b.numbers.size()) return std::numeric_limits<double>::infinity();
    double worst = 0;
    for (std::size_t i = 0; i < a.numbers.size(); ++i) {
        const double size = std::max(std::abs(a.numbers[i]), std::abs(b.numbers[i]));
        const double scale = std::max(a.scales[i], b.scales[i]);
        const double apart = std::abs(a.numbers[i] - b.numbers[i]) / (size < zero_below * scale ? scale : size);
        if (!(apart <= worst)) worst = apart;
    }
    return worst;
}

std::vector<std::string> methods_for(const Problem& problem) {
    if (problem.solver.method == "exact" && !exact_is_comparable(problem)) return {"exact"};
    std::vector<std::string> methods;
    for (const char* method : {"closed-form", "exact", "least-squares", "slsqp", "ipopt"}) {
        if (!why_not_applicable(method, problem).empty()) continue;
        if (std::string_view(method) == "exact" && !exact_is_comparable(problem)) continue;
        methods.emplace_back(method);
    }
    return methods;
}

namespace {

/// How far from the optimum a local search ends that starts this part of every variable away from it; nothing where the
/// start is as good as the optimum.
std::optional<double> difference_from(const KnownOptimum& known, double away, LocalMethod method) {
    Eigen::VectorXd start = known.x;
    for (Eigen::Index i = 0; i < start.size(); ++i)
        start[i] += (i % 2 == 0 ? away : -away) * (std::abs(start[i]) + away);
    start = within_bounds(known.program, start);
    settle_epigraphs(known.program, start);
    ProgramValues values;
    evaluate(known.program, start, false, values);
    LocalOutcome unmoved;
    unmoved.consider(known.program, start, values);
    if (error_of(unmoved.objective, unmoved.violation, known.objective) <= agree_within) return std::nullopt;
    double difference = std::numeric_limits<double>::infinity();
    // From where it is; and, should the mechanism not assemble there, from where the method first moves it.
    for (const bool near : {true, false}) {
        LocalLimits limits;
        limits.near_optimum = near;
        const LocalOutcome outcome = polished_search(known.program, start, method, limits);
        difference = std::min(difference, error_of(outcome.objective, outcome.violation, known.objective));
        if (difference <= agree_within) break;
    }
    return difference;
}

}  // namespace

Return return_from_nearby(const Problem& problem, const Design& design, std::string_view method) {
    Return found{0, std::numeric_limits<double>::infinity()};
    const auto known = optimum_at(problem, design);
    if (!known) return found;
    for (const double away : {1e-3, 1e-4, 1e-5, 1e-6}) {
        const auto difference = difference_from(*known, away, method == "ipopt" ? ipopt : slsqp);
        if (!difference) break;
        found = {away, *difference};
        if (*difference <= agree_within) break;
    }
    return found;
}

std::string_view why_alone(const Problem& problem, const Answer& answer) {
    if (answer.method == "given") return "every dimension is given";
    if (methods_for(problem).size() > 1) return "";
    return answer.method == "exact" ? "targets that are met exactly are no requirement of a search"
                                    : "no other applies";
}

std::string_view name_of(AnswerKind kind) {
    switch (kind) {
        case AnswerKind::optimum: return "optimum";
        case AnswerKind::design: return "design";
        case AnswerKind::trade_off: return "trade-off";
        case AnswerKind::infeasible: return "infeasible";
        default: return "none";
    }
}

}  // namespace mechwright::bench
