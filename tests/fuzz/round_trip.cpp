#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "synthesis/problem/reader.h"
#include "synthesis/problem/study/varied_problem.h"
#include "synthesis/problem/toml/made_table.h"
#include "synthesis/problem/toml/toml_text.h"
#include "synthesis/target/function/function_target.h"
#include "tests/fuzz/evaluation.h"
#include "tests/fuzz/require.h"

namespace mechwright::test {

namespace {

/// Numbers that are the same, or none both.
bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same(const Vector<double>& a, const Vector<double>& b) { return same(a.x, b.x) && same(a.y, b.y); }

template <class T>
bool same(const std::optional<T>& a, const std::optional<T>& b);

template <class Range>
requires requires(const Range& range) { range.begin(); }
bool same(const Range& a, const Range& b);

bool same(const DimensionRange& a, const DimensionRange& b) {
    return same(a.min, b.min) && same(a.max, b.max) && same(a.start, b.start) && a.named == b.named &&
           a.tie.terms == b.tie.terms && same(a.tie.constant, b.tie.constant);
}

bool same(const Requirement& a, const Requirement& b) {
    return a.quantity == b.quantity && same(a.equal, b.equal) && same(a.min, b.min) && same(a.max, b.max);
}

bool same(const ObjectiveTerm& a, const ObjectiveTerm& b) {
    return a.quantity == b.quantity && a.maximize == b.maximize && same(a.weight, b.weight);
}

bool same(const Objective& a, const Objective& b) { return a.worst == b.worst && same(a.terms, b.terms); }

bool same(const PathTarget& a, const PathTarget& b) {
    return same(a.points, b.points) && a.prescribed_timing == b.prescribed_timing && a.any_order == b.any_order &&
           same(a.crank_angles, b.crank_angles) && a.closed == b.closed && same(a.weights, b.weights) &&
           same(a.directions, b.directions) && same(a.body_length, b.body_length);
}

bool same(const FollowedTarget& a, const FollowedTarget& b) { return a.shape == b.shape && a.full_turn == b.full_turn; }

bool same_function(const FunctionTarget* a, const FunctionTarget* b) {
    if (!a || !b) return a == b;
    return a->expression == b->expression && same(a->samples, b->samples) && same(a->from, b->from) &&
           same(a->to, b->to) && same(a->accuracy_points, b->accuracy_points);
}

bool same(const AskedOverInput& a, const AskedOverInput& b) {
    return a.name == b.name && same(a.weight, b.weight) && same_function(a.function.get(), b.function.get()) &&
           a.followed == b.followed && a.full_turn == b.full_turn;
}

bool same(const SolverOptions& a, const SolverOptions& b) {
    return a.method == b.method && a.starts == b.starts && a.seed == b.seed && same(a.time_limit, b.time_limit) &&
           same(a.tolerance, b.tolerance) && a.pareto == b.pareto;
}

template <class T>
bool same(const std::optional<T>& a, const std::optional<T>& b) {
    return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

template <class Range>
requires requires(const Range& range) { range.begin(); }
bool same(const Range& a, const Range& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return same(x, y); });
}

void check_same(const Problem& a, const Problem& b) {
    require(a.title == b.title && a.mechanism->meaning == b.mechanism->meaning && a.units.degrees == b.units.degrees &&
                a.units.length == b.units.length,
            "the head survives a round trip");
    require(same(a.dimensions, b.dimensions) && a.assemblies == b.assemblies, "dimensions survive a round trip");
    require(same(a.requirements, b.requirements), "requirements survive a round trip");
    require(same(a.objective, b.objective), "an objective survives a round trip");
    require(same(a.path, b.path), "a path survives a round trip");
    require(same(a.crank_range, b.crank_range) && same(a.settings, b.settings), "motion and settings survive");
    require(same_function(a.function.get(), b.function.get()) && same(a.followed, b.followed),
            "a function or line survives a round trip");
    require(!a.over_input == !b.over_input && (!a.over_input || same(*a.over_input, *b.over_input)),
            "functions, lines and arcs with names survive a round trip");
    require(a.has_instant == b.has_instant && a.assemblies == b.assemblies &&
                (program_of(*a.mechanism) == nullptr) == (program_of(*b.mechanism) == nullptr) && a.wanted == b.wanted,
            "the rest survives a round trip");
    require(same(a.solver, b.solver), "solver options survive a round trip");
}

void check_read_again(const ReadProblem& again, const Problem& problem) {
    require(again.ok(), "a valid problem that is printed is valid");
    check_same(problem, again.problem);
}

}  // namespace

void check_round_trip(std::string_view text, const Problem& problem) {
    check_read_again(VariedProblem(text, problem.file).read(), problem);
    reading::Messages messages{.file = problem.file};
    const std::optional<toml::table> table = reading::parse_toml(text, messages);
    require(table.has_value(), "a valid problem is TOML");
    check_read_again(parse_problem(reading::text_of(*table), problem.file), problem);
}

}  // namespace mechwright::test
