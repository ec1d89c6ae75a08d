#include "synthesis/search/multistart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

#include "synthesis/program/assess.h"
#include "synthesis/search/optima.h"
#include "synthesis/search/starts.h"
#include "synthesis/search/work_sharing.h"

namespace mechwright {

namespace {

/// Screened candidates for each start. With a path most of them are worth nothing, and the good ones are rare.
constexpr int candidates_without_path = 16;
constexpr int candidates_with_path = 400;
/// Every variant gets at least this many starts, however many variants there are.
constexpr int least_starts_of_variant = 4;
struct Slot {
    std::optional<Solution> solution;
    long evaluations = 0;
    bool done = false;
};

/// An objective below this is small against what the program was scaled for: tolerances then mean too little.
constexpr double small_objective = 1e-2;
/// Times that a search goes on in units of the objective reached, and the part by which that has to pay each time.
constexpr int most_magnifications = 4;
constexpr double pays_from = 1e-3;

bool asks_for_one_worst(const Program& program) {
    return program.epigraphs.size() == 1 && program.epigraphs.front().above && program.objective.outputs.empty();
}

LocalOutcome search(const Program& program, const Eigen::VectorXd& start, LocalMethod method,
                    const LocalLimits& limits) {
    LocalOutcome outcome = polish(program, method(program, start, limits), limits);
    for (int pass = 0; pass < most_magnifications && !program.closest_to_reference; ++pass) {
        const double size = std::abs(outcome.objective);
        if (outcome.violation > LocalOutcome::feasible_below || !(size > 0 && size < small_objective)) break;
        const Program great = magnified(program, size);
        Eigen::VectorXd x = outcome.x;
        settle_epigraphs(great, x);
        if (pass == 0 && asks_for_one_worst(great)) x = levelled(great, x, limits);
        LocalOutcome further = polish(great, method(great, x, limits), limits);
        outcome.evaluations += further.evaluations;
        if (further.violation > LocalOutcome::feasible_below || !(further.objective * size < outcome.objective)) break;
        const bool pays = further.objective * size < outcome.objective - pays_from * size;
        outcome.x = std::move(further.x);
        outcome.objective = further.objective * size;
        settle_epigraphs(program, outcome.x);
        if (!pays) break;
    }
    return outcome;
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
    std::vector<const Solution*> found;
    for (const Slot& slot : slots)
        if (slot.solution) found.push_back(&*slot.solution);
    result.optima = distinct_optima(problem, found, result.report);
    return result;
}

}  // namespace mechwright
