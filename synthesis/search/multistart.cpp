#include "synthesis/search/multistart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

#include "synthesis/program/assess.h"
#include "synthesis/search/starts.h"
#include "synthesis/search/work_sharing.h"

namespace mechwright {

namespace {

/// Screened candidates for each start. With a path most of them are worth nothing, and the good ones are rare.
constexpr int candidates_without_path = 16;
constexpr int candidates_with_path = 400;
/// Every variant gets at least this many starts, however many variants there are.
constexpr int least_starts_of_variant = 4;
/// Designs whose dimensions agree to this are one optimum.
constexpr double same_within = 1e-5;
/// Objectives that agree to this (or to this part of the problem's scale) are equally good.
constexpr double same_objective_within = 1e-7;

struct Slot {
    std::optional<Solution> solution;
    long evaluations = 0;
    bool done = false;
};

bool same_design(const Problem& problem, const Design& a, const Design& b) {
    if (a.assembly != b.assembly) return false;
    double size = 0;
    for (std::size_t i = 0; i < a.dimensions.size(); ++i)
        if (problem.mechanism->dimensions[i].kind == DimensionKind::length)
            size = std::max({size, a.dimensions[i], b.dimensions[i]});
    for (std::size_t i = 0; i < a.dimensions.size(); ++i) {
        const bool is_angle = problem.mechanism->dimensions[i].kind == DimensionKind::angle;
        const double difference = a.dimensions[i] - b.dimensions[i];
        if (is_angle ? std::abs(std::sin(difference / 2)) > same_within : std::abs(difference) > same_within * size)
            return false;
    }
    return true;
}

/// Distinct optima in order of preference; equal ones keep the order of their starts.
std::vector<Solution> distinct(const Problem& problem, const std::vector<Slot>& slots, SearchReport& report) {
    std::vector<const Solution*> all;
    for (const Slot& slot : slots)
        if (slot.solution) all.push_back(&*slot.solution);
    std::stable_sort(all.begin(), all.end(),
                     [&](const Solution* a, const Solution* b) { return preferred(problem, *a, *b); });
    std::vector<Solution> optima;
    for (const Solution* s : all) {
        const bool known = std::any_of(optima.begin(), optima.end(),
                                       [&](const Solution& o) { return same_design(problem, o.design, s->design); });
        if (!known) optima.push_back(*s);
        const bool as_good = s->feasible && std::abs(s->objective - optima.front().objective) <=
                                                same_objective_within * std::abs(optima.front().objective);
        if (as_good) ++report.hits;
    }
    report.local_optima =
        static_cast<int>(std::count_if(optima.begin(), optima.end(), [](const Solution& s) { return s.feasible; }));
    return optima;
}

/// Expected share of starts that lead to optima not yet seen, from the number of searches and of distinct optima
/// (Boender and Rinnooy Kan 1987).
double unseen_share(int searches, int optima) {
    const double n = searches;
    const double w = optima;
    if (searches < 2) return 1;
    return std::min(1.0, w * (w + 1) / (n * (n - 1)));
}

LocalOutcome search(const Program& program, const Eigen::VectorXd& start, LocalMethod method,
                    const LocalLimits& limits) {
    return polish(program, method(program, start, limits), limits);
}

/// Least shortfall of the required inequalities first; then the objective, if nothing falls short.
LocalOutcome search_nearly_feasible(const Program& program, const Eigen::VectorXd& start, LocalMethod method,
                                    const LocalLimits& limits) {
    const Program least_shortfall = relaxed(program);
    Eigen::VectorXd wide(start.size() + 1);
    wide.head(start.size()) = start;
    wide[start.size()] = 1;
    const LocalOutcome near = search(least_shortfall, wide, method, limits);
    if (near.x.size() == 0) return near;
    Eigen::VectorXd x = near.x.head(start.size());
    settle_epigraphs(program, x);
    LocalOutcome outcome =
        near.violation <= LocalOutcome::feasible_below && near.objective <= LocalOutcome::feasible_below
            ? search(program, x, method, limits)
            : LocalOutcome{};
    if (outcome.x.size() == 0) outcome.x = x;
    outcome.evaluations += near.evaluations;
    return outcome;
}

}  // namespace

Multistart multistart(const Problem& problem, LocalMethod method, const RunOptions& options,
                      std::chrono::steady_clock::time_point deadline) {
    std::vector<Program> programs;
    for (const Variant& variant : variants(problem))
        programs.push_back(build_program(problem, variant));
    Multistart result;
    if (programs.empty()) return result;

    const auto count = static_cast<int>(programs.size());
    const int each =
        std::max((problem.solver.starts + count - 1) / count, std::min(least_starts_of_variant, problem.solver.starts));
    const int total = each * count;
    const int candidates = problem.path ? candidates_with_path : candidates_without_path;
    LocalLimits limits;
    limits.deadline = deadline;
    limits.stop = options.stop;

    std::vector<Slot> slots(static_cast<std::size_t>(total));
    std::mutex reporting;
    int done = 0;
    std::optional<Solution> best;
    const auto run = [&](const auto& search) {
        done = 0;
        share_work(total, options.jobs, [&](int task) {
            if (limits.reached()) return;
            const auto variant = static_cast<std::size_t>(task % count);
            Slot& slot = slots[static_cast<std::size_t>(task)];
            const Eigen::VectorXd start = start_point(programs[variant], problem.solver.seed, task / count, candidates);
            LocalOutcome outcome = search(programs[variant], start);
            slot.evaluations += outcome.evaluations;
            if (outcome.x.size() > 0) slot.solution = assess(problem, design_at(programs[variant], outcome.x));
            slot.done = !limits.reached();
            if (!options.progress) return;
            const std::lock_guard lock(reporting);
            ++done;
            if (slot.solution && slot.solution->feasible && (!best || preferred(problem, *slot.solution, *best)))
                best = slot.solution;
            options.progress(done, total, best ? best->objective : std::numeric_limits<double>::quiet_NaN());
        });
    };
    run([&](const Program& program, const Eigen::VectorXd& start) { return search(program, start, method, limits); });
    const auto feasible = [](const Slot& slot) { return slot.solution && slot.solution->feasible; };
    if (std::none_of(slots.begin(), slots.end(), feasible) && !limits.reached())
        run([&](const Program& program, const Eigen::VectorXd& start) {
            return search_nearly_feasible(program, start, method, limits);
        });

    for (const Slot& slot : slots) {
        result.report.starts += slot.done ? 1 : 0;
        result.report.evaluations += slot.evaluations;
        result.stopped = result.stopped || !slot.done;
    }
    result.optima = distinct(problem, slots, result.report);
    result.report.missed_chance = unseen_share(result.report.starts, result.report.local_optima);
    return result;
}

}  // namespace mechwright
