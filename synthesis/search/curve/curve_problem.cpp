#include "synthesis/search/curve/curve_problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/numbers/scalar.h"
#include "synthesis/program/condition_margin.h"
#include "synthesis/target/path/rows/stretch.h"

namespace mechwright {

namespace {

/// A design may lie where its kind ends, to rounding.
constexpr double rounding_of_margin = 1e-10;

bool meets(const std::vector<LinearCondition>& conditions, const CurveArguments& a) {
    return std::all_of(conditions.begin(), conditions.end(), [&](const LinearCondition& c) {
        return margin_of(c, a) >= condition_margin - rounding_of_margin;
    });
}

/// A requirement missed by a part counts as if every target were missed by about three times that part of the spread.
constexpr double per_requirement = 10;

/// The rows of a program that requirements stand for; nothing where one of them speaks of the path.
std::optional<std::vector<std::size_t>> requirement_rows(const Program& program) {
    const std::vector<std::size_t> beside = rows_beside_path(program);
    std::vector<std::size_t> rows;
    for (std::size_t r = 0; r < program.rows.size(); ++r) {
        if (!program.rows[r].requirement) continue;
        if (std::find(beside.begin(), beside.end(), r) == beside.end()) return std::nullopt;
        rows.push_back(r);
    }
    return rows;
}

GroupedTargets grouped(const std::vector<Vector<double>>& targets, const std::vector<double>& weights) {
    constexpr std::size_t lanes = std::tuple_size_v<Group>;
    GroupedTargets g;
    g.count = targets.size();
    const std::size_t groups = (targets.size() + lanes - 1) / lanes;
    g.x.resize(groups);
    g.y.resize(groups);
    g.weight.resize(groups);
    for (std::size_t i = 0; i < groups * lanes; ++i) {
        const std::size_t k = std::min(i, targets.size() - 1);
        g.x[i / lanes][i % lanes] = targets[k].x;
        g.y[i / lanes][i % lanes] = targets[k].y;
        g.weight[i / lanes][i % lanes] = i < targets.size() ? weights[k] : 0;
    }
    return g;
}

void set_spread(CurveProblem& p, const std::vector<Vector<double>>& targets, const std::vector<double>& weights) {
    Vector<double> middle{};
    for (std::size_t i = 0; i < targets.size(); ++i) {
        p.weight += weights[i];
        middle = middle + weights[i] * targets[i];
    }
    middle = (1 / p.weight) * middle;
    double square = 0;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const Vector<double> from = targets[i] - middle;
        square += weights[i] * dot(from, from);
    }
    p.spread = std::sqrt(square / p.weight);
}

using Order = std::vector<std::size_t>;

double distance(const Vector<double>& a, const Vector<double>& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Where targets are along a way in such an order; its length follows.
std::vector<double> along_way(const std::vector<Vector<double>>& targets, const Order& order, bool closed) {
    std::vector<double> along(targets.size() + 1, 0.0);
    double length = 0;
    for (std::size_t k = 1; k < order.size(); ++k) {
        length += distance(targets[order[k - 1]], targets[order[k]]);
        along[order[k]] = length;
    }
    along.back() = length + (closed ? distance(targets[order.back()], targets[order.front()]) : 0);
    return along;
}

/// From the first target to the nearest one that is left, again and again.
Order by_nearest_left(const std::vector<Vector<double>>& targets) {
    Order order(targets.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (auto next = order.begin() + 1; next < order.end(); ++next) {
        const Vector<double>& here = targets[*(next - 1)];
        const auto nearest = std::min_element(next, order.end(), [&](std::size_t a, std::size_t b) {
            return distance(targets[a], here) < distance(targets[b], here);
        });
        std::iter_swap(next, nearest);
    }
    return order;
}

/// The way through the targets as they are listed, or, where that is shorter, to the nearest one that is left each
/// time: points in any order are seldom listed without any.
void set_way(CurveProblem& p, const std::vector<Vector<double>>& targets) {
    Order listed(targets.size());
    std::iota(listed.begin(), listed.end(), std::size_t{0});
    p.way = along_way(targets, listed, p.closed);
    std::vector<double> other = along_way(targets, by_nearest_left(targets), p.closed);
    if (other.back() < p.way.back()) p.way = std::move(other);
    const double length = p.way.back();
    p.way.pop_back();
    for (double& along : p.way)
        along /= length;
}

}  // namespace

bool CurveProblem::keeps_from_borders(const CurveArguments& a) const {
    return std::all_of(fit->kin->borders().begin(), fit->kin->borders().end(), [&](const LinearCondition& c) {
        bool moves = false;
        for (std::size_t i = 0; i < c.coefficients.size(); ++i)
            moves = moves || (c.coefficients[i] != 0 && is_free(i));
        return !moves || std::abs(margin_of(c, a)) >= condition_margin - rounding_of_margin;
    });
}

bool CurveProblem::allows(std::size_t assembly, const CurveArguments& a) const {
    return keeps_from_borders(a) && std::any_of(kinds.begin(), kinds.end(), [&](const CurveKind& kind) {
               return kind.assembly == assembly && meets(*kind.conditions, a);
           });
}

std::optional<CurveProblem> curve_problem(const std::vector<Program>& programs) {
    if (programs.empty()) return std::nullopt;
    const Program& program = programs.front();
    const Problem& problem = *program.problem;
    const Mechanism& mechanism = *problem.mechanism;
    if (!problem.path || !problem.path->any_order || !mechanism.point || !mechanism.point->curve.sample ||
        problem.crank_range || has_ties(problem) || !problem.path->parts.empty() || problem.path->guides_body())
        return std::nullopt;
    CurveProblem p;
    p.programs = &programs;
    for (const Program& one : programs) {
        auto rows = requirement_rows(one);
        if (!rows || !one.variant.choices.empty() || (!rows->empty() && depends_on_stretch(one))) return std::nullopt;
        p.rows.push_back(std::move(*rows));
    }
    p.fit = &mechanism.point->curve;
    p.set = widest_instruction_set();
    p.arguments = mechanism.point->reads.size();
    p.lengths = p.arguments - 5;
    p.free_size = true;
    for (std::size_t i = 0; i < p.arguments; ++i) {
        const std::size_t dimension = mechanism.point->reads[i];
        const std::ptrdiff_t v = program.variable_of[dimension];
        p.lower[i] = v >= 0 ? program.variables[static_cast<std::size_t>(v)].lower : program.dimensions[dimension];
        p.upper[i] = v >= 0 ? program.variables[static_cast<std::size_t>(v)].upper : program.dimensions[dimension];
        if (i < p.lengths) p.free_size = p.free_size && p.is_free(i);
    }
    p.free_size = p.free_size && p.is_free(p.lengths) && p.is_free(p.lengths + 1);
    p.free_placement = p.is_free(p.lengths + 2) && p.is_free(p.lengths + 3) && p.is_free(p.lengths + 4);
    for (const Program& one : programs)
        p.kinds.push_back({one.variant.assembly, &mechanism.families[one.variant.family].conditions});
    p.targets = grouped(program.targets, problem.path->weights);
    p.closed = problem.path->closed;
    set_spread(p, program.targets, problem.path->weights);
    set_way(p, program.targets);
    p.weight_of_rows = per_requirement * p.weight * p.spread * p.spread;
    return p.spread > 0 ? std::optional(p) : std::nullopt;
}

std::size_t program_of(const std::vector<Program>& programs, const CurveArguments& arguments, std::size_t assembly) {
    const auto at = std::find_if(programs.begin(), programs.end(), [&](const Program& p) {
        return p.variant.assembly == assembly &&
               meets(p.problem->mechanism->families[p.variant.family].conditions, arguments);
    });
    return static_cast<std::size_t>(at - programs.begin());
}

Eigen::VectorXd point_with(const Program& program, const CurveArguments& arguments) {
    Eigen::VectorXd x = program.reference;
    const auto& reads = program.problem->mechanism->point->reads;
    for (std::size_t i = 0; i < reads.size(); ++i)
        if (const std::ptrdiff_t v = program.variable_of[reads[i]]; v >= 0) x[v] = arguments[i];
    return x;
}

CurveArguments arguments_at(const Program& program, const Eigen::VectorXd& x) {
    CurveArguments a{};
    const auto& reads = program.problem->mechanism->point->reads;
    for (std::size_t i = 0; i < reads.size(); ++i) {
        const std::ptrdiff_t v = program.variable_of[reads[i]];
        a[i] = v >= 0 ? x[v] : program.dimensions[reads[i]];
    }
    return a;
}

CurveArguments within_ranges(const CurveProblem& p, CurveArguments a) {
    double& tilt = a[p.arguments - 1];
    const double turn = 2 * pi<double>();
    tilt -= turn * std::floor((tilt - p.lower[p.arguments - 1]) / turn);
    for (std::size_t i = 0; i < p.arguments; ++i)
        a[i] = std::clamp(a[i], p.lower[i], p.upper[i]);
    return a;
}

}  // namespace mechwright
