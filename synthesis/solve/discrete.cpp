#include "synthesis/solve/discrete.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "synthesis/problem/allowed_values.h"
#include "synthesis/program/assess.h"
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
        if (result.candidates.empty() || !result.candidates.front().feasible) return;
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
        if (whole.candidates.empty() || !whole.candidates.front().feasible) {
            keep_all(whole);
            found.infeasible = whole.infeasible;
            found.report.proof = whole.infeasible ? whole.report.proof : nullptr;
            found.note = whole.note;
            found.stopped = end.reached();
            return;
        }
        const Solution& best = whole.candidates.front();
        report.continuous = best.objective;
        push({std::move(all), best.design, cost(best.objective)});
        while (!open.empty() && !end.reached() && !is_behind(open.front().cost)) {
            if (!problem.objective && least < unlimited_cost) break;  // any design will do
            split(pop());
        }
        if (!found.candidates.empty() && is_at_zero(problem, found.candidates.front()))
            found.report.proof = proof_by_zero(problem);
        found.stopped = end.reached();
        if (found.stopped && !open.empty() && least < unlimited_cost)
            report.gap = std::max(0.0, least - open.front().cost);
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
