#include "synthesis/solve/discrete.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "synthesis/problem/allowed_values.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/condition_margin.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/zero_objective.h"
#include "synthesis/solve/methods.h"
#include "synthesis/solve/parts.h"

namespace mechwright {

namespace {

/// A part of the allowed values, and the best design of its ranges.
struct Part {
    std::vector<DimensionRange> ranges;  ///< by discrete dimension
    Design design;
    double cost;
};

/// Kinds of motion end at change points, which programs keep from by this much, too. A part of the motion need not
/// come to one.
bool keeps_from_change_points(const Problem& problem, const Design& design) {
    const Mechanism& mechanism = *problem.mechanism;
    if (problem.crank_range || has_moving_ends(problem)) return true;
    const auto& conditions = mechanism.families[motion_of(problem, design).family].conditions;
    const double least = condition_margin * longest_length(mechanism, design.dimensions);
    return std::all_of(conditions.begin(), conditions.end(),
                       [&](const LinearCondition& c) { return margin_of(c, design.dimensions) >= least; });
}

struct BranchAndBound {
    const Problem& problem;
    const RunOptions& options;
    const RunEnd& end;
    std::vector<std::size_t> discrete{};  ///< dimensions
    std::vector<Part> open{};             ///< a heap, the least cost on top
    std::set<std::vector<double>> settled{};
    Found found{};
    double least = unlimited_cost;  ///< of designs that were found
    DiscreteReport report{};

    static constexpr int starts_of_part = 8;     ///< beside the one near the best design of what it is a part of
    static constexpr std::size_t most_kept = 4;  ///< designs of one choice
    static constexpr double unlimited_cost = std::numeric_limits<double>::infinity();
    /// Combinations of allowed values that are all looked at, where parts of them would be left out because no search
    /// found a design there: so many where nothing else is left to be found, and so many where something is.
    static constexpr std::size_t most_combinations = 4000, most_combinations_searched = 64;

    /// Less is better.
    double cost(double objective) const { return maximizes(problem) ? -objective : objective; }

    bool is_behind(double of_part) const {
        return least < unlimited_cost && !(of_part < least - problem.solver.tolerance * std::abs(least));
    }

    /// Any value of the ranges is allowed; searches begin near a design of the part around it.
    Found solved(const std::vector<DimensionRange>& ranges, const Design* near) {
        Problem part = problem;
        part.text.clear();  // which asks for something else
        part.solver.pareto = 0;
        for (std::size_t k = 0; k < discrete.size(); ++k)
            part.dimensions[discrete[k]] = continuous(ranges[k]);
        if (near) {
            part.solver.starts = std::min(part.solver.starts, starts_of_part);
            begin_at(part, *near);
        }
        RunOptions of_part = quiet(options);
        of_part.neighbour = nullptr;
        Found result = find_designs(part, of_part, end);
        add_work(found.report, result.report);
        ++report.problems;
        if (options.progress)
            options.progress(static_cast<int>(report.problems),
                             static_cast<int>(report.problems) + static_cast<int>(open.size()),
                             found.candidates.empty() ? std::nan("") : found.candidates.front().objective);
        return result;
    }

    void keep(const Design& design) {
        if (!keeps_from_change_points(problem, design)) return;
        Solution solution = assess(problem, design);
        if (solution.feasible) least = std::min(least, cost(solution.objective));
        const auto place =
            std::upper_bound(found.candidates.begin(), found.candidates.end(), solution,
                             [&](const Solution& a, const Solution& b) { return preferred(problem, a, b); });
        found.candidates.insert(place, std::move(solution));
    }

    /// The designs whose discrete dimensions have the allowed values that are nearest to those of a design.
    void settle(const Design& design) {
        std::vector<double> values;
        std::vector<DimensionRange> numbers;
        for (const std::size_t i : discrete) {
            const DimensionRange& range = problem.dimensions[i];
            values.push_back(nearest_allowed(range, design.dimensions[i]));
            numbers.push_back(allowed_between(range, values.back(), values.back()));
        }
        if (!settled.insert(std::move(values)).second || end.reached()) return;
        keep_all(solved(numbers, &design));
    }

    void keep_all(const Found& result) {
        for (std::size_t i = 0; i < std::min(most_kept, result.candidates.size()); ++i)
            keep(result.candidates[i].design);
    }

    /// Solves a part. What is no better than a design that was found is left out, and what has no choice left is kept.
    /// What could not be solved to its end promises what it is a part of does.
    void examine(std::vector<DimensionRange> ranges, const Design* near, double of_whole) {
        if (end.reached()) return push({std::move(ranges), *near, of_whole});
        const bool chosen = std::none_of(ranges.begin(), ranges.end(), [](const auto& r) { return r.discrete(); });
        if (chosen) {
            std::vector<double> values;
            for (const DimensionRange& range : ranges)
                values.push_back(range.min);
            if (!settled.insert(std::move(values)).second) return;
            keep_all(solved(ranges, near));
            if (end.reached()) push({std::move(ranges), *near, of_whole});
            return;
        }
        const Found result = solved(ranges, near);
        if (end.reached()) return push({std::move(ranges), *near, of_whole});
        if (result.candidates.empty() || !result.candidates.front().feasible) {
            if (!result.infeasible) ++report.left_out;
            return;
        }
        const double promised = cost(result.candidates.front().objective);
        if (is_behind(promised)) return;
        push({std::move(ranges), result.candidates.front().design, promised});
    }

    static bool comes_later(const Part& a, const Part& b) { return a.cost > b.cost; }

    void push(Part part) {
        open.push_back(std::move(part));
        std::push_heap(open.begin(), open.end(), comes_later);
    }

    Part pop() {
        std::pop_heap(open.begin(), open.end(), comes_later);
        Part part = std::move(open.back());
        open.pop_back();
        return part;
    }

    double value_of(const Part& part, std::size_t k) const {
        return std::clamp(part.design.dimensions[discrete[k]], part.ranges[k].min, part.ranges[k].max);
    }

    /// Of the discrete dimensions with a choice left that whose value is farthest from an allowed one, relative to how
    /// far those beside it are apart.
    std::size_t to_split(const Part& part) const {
        std::size_t chosen = 0;
        double farthest = -1;
        for (std::size_t k = 0; k < discrete.size(); ++k) {
            if (!part.ranges[k].discrete()) continue;
            const double value = value_of(part, k);
            const auto [below, above] = allowed_around(part.ranges[k], value);
            const double off = std::min(value - below, above - value) / (above - below);
            if (off <= farthest) continue;
            farthest = off;
            chosen = k;
        }
        return chosen;
    }

    void split(const Part& part) {
        settle(part.design);
        if (is_behind(part.cost)) return;
        const std::size_t k = to_split(part);
        const DimensionRange& whole = part.ranges[k];
        const auto [below, above] = allowed_around(whole, value_of(part, k));
        for (const auto& [from, to] : {std::pair(whole.min, below), std::pair(above, whole.max)}) {
            std::vector<DimensionRange> ranges = part.ranges;
            ranges[k] = allowed_between(whole, from, to);
            examine(std::move(ranges), &part.design, part.cost);
        }
    }

    /// The combination of allowed values with a number, in the order of numbers with a digit for each dimension.
    std::vector<double> combination(std::size_t number) const {
        std::vector<double> values;
        for (const std::size_t i : discrete) {
            const std::size_t count = count_allowed(problem.dimensions[i]);
            values.push_back(allowed_value(problem.dimensions[i], number % count));
            number /= count;
        }
        return values;
    }

    /// How many there are; nothing where that is more than a number.
    std::optional<std::size_t> combinations(std::size_t most) const {
        std::size_t all = 1;
        for (const std::size_t i : discrete) {
            const std::size_t count = count_allowed(problem.dimensions[i]);
            if (count > most / all) return {};
            all *= count;
        }
        return all;
    }

    /// The designs of a combination, where nothing but the assembly is left to be found.
    void keep_given(const std::vector<double>& values) {
        Design design;
        for (const DimensionRange& range : problem.dimensions)
            design.dimensions.push_back(range.min);
        for (std::size_t k = 0; k < discrete.size(); ++k)
            design.dimensions[discrete[k]] = values[k];
        for (const std::size_t assembly : problem.assemblies) {
            design.assembly = assembly;
            keep(design);
        }
    }

    /// Whether nothing but discrete dimensions is to be found.
    bool is_all_discrete() const {
        return !problem.path && std::all_of(problem.dimensions.begin(), problem.dimensions.end(),
                                            [](const auto& r) { return r.fixed() || r.discrete(); });
    }

    /// Looks at every combination of allowed values that was not, where there are few. False: there are too many.
    bool look_at_all(const Design& near) {
        const bool given = is_all_discrete();
        const auto all = combinations(given ? most_combinations : most_combinations_searched);
        if (!all) return false;
        for (std::size_t number = 0; number < *all && !end.reached(); ++number) {
            const std::vector<double> values = combination(number);
            if (given) {
                keep_given(values);
            } else if (settled.insert(values).second) {
                std::vector<DimensionRange> numbers;
                for (std::size_t k = 0; k < discrete.size(); ++k)
                    numbers.push_back(allowed_between(problem.dimensions[discrete[k]], values[k], values[k]));
                keep_all(solved(numbers, &near));
            }
            keep_best();
        }
        if (given && !end.reached()) report.combinations = static_cast<long>(*all);
        return !end.reached();
    }

    void keep_best() {
        constexpr std::size_t most = 64;
        if (found.candidates.size() > most) found.candidates.resize(most);
    }

    void branch(Part whole) {
        push(std::move(whole));
        while (!open.empty() && !end.reached() && !is_behind(open.front().cost)) {
            if (!problem.objective && least < unlimited_cost) break;  // any design will do
            split(pop());
        }
    }

    void run() {
        for (std::size_t i = 0; i < problem.dimensions.size(); ++i)
            if (problem.dimensions[i].discrete()) discrete.push_back(i);
        std::vector<DimensionRange> all;
        for (const std::size_t i : discrete)
            all.push_back(problem.dimensions[i]);
        Found whole = solved(all, nullptr);
        found.report.method = whole.report.method;
        found.report.bound = whole.report.bound;
        found.report.boxes = whole.report.boxes;
        const bool feasible = !whole.candidates.empty() && whole.candidates.front().feasible;
        const bool few = is_all_discrete() && combinations(most_combinations);
        if (feasible) {
            const Solution& best = whole.candidates.front();
            report.continuous = best.objective;
            if (!few) branch({std::move(all), best.design, cost(best.objective)});
        } else {
            found.infeasible = whole.infeasible;
            found.report.proof = whole.infeasible ? whole.report.proof : nullptr;
            found.note = whole.note;
            report.left_out = whole.infeasible ? 0 : 1;
            if (!few && !whole.candidates.empty()) settle(whole.candidates.front().design);
        }
        const bool any_will_do = !problem.objective && least < unlimited_cost;
        const bool may_miss = !feasible || report.left_out > 0 || few;
        if (may_miss && !any_will_do && !whole.candidates.empty() && look_at_all(whole.candidates.front().design))
            report.left_out = 0;
        if (!found.infeasible && !found.candidates.empty() && is_at_zero(problem, found.candidates.front()))
            found.report.proof = proof_by_zero(problem);
        found.stopped = end.reached();
        if (found.stopped && least < unlimited_cost) {
            if (few && report.continuous) report.gap = std::max(0.0, least - cost(*report.continuous));
            if (!open.empty()) report.gap = std::max(0.0, least - open.front().cost);
        }
        found.report.local_optima = static_cast<int>(
            std::count_if(found.candidates.begin(), found.candidates.end(), [](const auto& s) { return s.feasible; }));
    }
};

}  // namespace

Found discrete_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    BranchAndBound search{problem, options, end};
    search.run();
    search.found.report.discrete = search.report;
    return std::move(search.found);
}

}  // namespace mechwright
