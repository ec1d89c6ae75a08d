#include "synthesis/search/multistart.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <map>
#include <mutex>
#include <optional>

#include "synthesis/program/assess.h"
#include "synthesis/program/choices.h"
#include "synthesis/program/search_trace.h"
#include "synthesis/program/work_sharing.h"
#include "synthesis/program/zero_objective.h"
#include "synthesis/search/best_assemblies.h"
#include "synthesis/search/optima.h"
#include "synthesis/search/polished_search.h"
#include "synthesis/search/starts.h"

namespace mechwright {

using Eigen::VectorXd;

namespace {

/// Every variant gets at least this many starts, however many variants there are.
constexpr int least_starts_of_variant = 4;

/// One of the starts of a program.
struct SearchTask {
    const Program* program;
    int number;      ///< no other program of its family and assembly has the same: their starts are drawn alike
    bool preferred;  ///< begins with the preferred values
};

struct Slot {
    std::optional<Solution> solution;
    long evaluations = 0;
    long hessians = 0;
    DrawCounts counts{};
    bool done = false;
    std::vector<SearchEnd> ends{};  ///< where a trace is kept
};

/// Least shortfall of the required inequalities first; then the objective, if nothing falls short.
LocalOutcome search_nearly_feasible(const Program& program, const Eigen::VectorXd& start, LocalMethod method,
                                    const LocalLimits& limits) {
    const Program least_shortfall = relaxed(program);
    Eigen::VectorXd wide(start.size() + 1);
    wide.head(start.size()) = start;
    wide[start.size()] = 1;
    const LocalOutcome near = polished_search(least_shortfall, wide, method, limits);
    if (near.x.size() == 0) return near;
    Eigen::VectorXd x = near.x.head(start.size());
    settle_epigraphs(program, x);
    LocalOutcome outcome =
        near.violation <= LocalOutcome::feasible_below && near.objective <= LocalOutcome::feasible_below
            ? polished_search(program, x, method, limits)
            : LocalOutcome{};
    if (outcome.x.size() == 0) outcome.x = x;
    if (outcome.verdict.empty()) outcome.verdict = near.verdict;
    outcome.evaluations += near.evaluations;
    outcome.hessians += near.hessians;
    return outcome;
}

/// The programs of variants without choices for requirements, as far as there are such choices.
std::vector<Program> without_choices(const Problem& problem, const std::vector<Program>& programs,
                                     const std::vector<std::size_t>& kept) {
    std::vector<Program> open;
    for (const std::size_t i : kept) {
        const std::optional<Variant> variant = without_choices(problem, programs[i].variant);
        const auto is_known = [&](const Program& known) { return known.variant == *variant; };
        if (variant && std::none_of(open.begin(), open.end(), is_known))
            open.push_back(build_program(problem, *variant));
    }
    return open;
}

/// So many starts of each program in turn, with numbers after those of earlier tasks of the same family and assembly.
void add_tasks(const std::vector<const Program*>& programs, int starts, std::vector<SearchTask>& tasks) {
    using Drawn = std::array<std::size_t, 2>;  // what draws depend on
    std::map<Drawn, int> next;
    const auto drawn = [](const Program& program) { return Drawn{program.variant.family, program.variant.assembly}; };
    for (const SearchTask& task : tasks)
        ++next[drawn(*task.program)];
    for (int start = 0; start < starts; ++start)
        for (const Program* program : programs)
            tasks.push_back({program, next[drawn(*program)]++, start == 0});
}

/// The searches of programs without choices for requirements, if there are any, then of those with them: either kind
/// has half of the starts, and every program with choices at least a few.
std::vector<SearchTask> search_tasks(const Problem& problem, const std::vector<const Program*>& without,
                                     const std::vector<const Program*>& with) {
    const int starts = problem.solver.starts;
    const std::size_t kinds = without.empty() ? 1 : 2;
    const auto starts_of_each = [&](const std::vector<const Program*>& programs) {
        const auto parts = static_cast<int>(programs.size() * kinds);
        return (starts + parts - 1) / parts;
    };
    std::vector<SearchTask> tasks;
    if (!without.empty()) add_tasks(without, starts_of_each(without), tasks);
    add_tasks(with, std::max(starts_of_each(with), std::min(least_starts_of_variant, starts)), tasks);
    return tasks;
}

/// Where a local search ended, and what that is worth; nothing where nothing assembled.
struct LocalEnd {
    LocalOutcome outcome;
    std::optional<Solution> solution{};
};

/// Searches a program from a start. One without choices for requirements is searched on with those of its end where
/// that does not meet them.
template <class Search>
LocalEnd searched(const Program& program, const VectorXd& start, const Search& search) {
    const Problem& problem = *program.problem;
    LocalEnd end{search(program, start)};
    if (end.outcome.x.size() == 0) return end;
    end.solution = assess(problem, design_at(program, end.outcome.x));
    if (end.solution->feasible || without_choices(problem, program.variant) != program.variant) return end;
    const Program chosen = build_program(problem, with_choices_at(program, end.outcome.x));
    LocalOutcome further = search(chosen, end.outcome.x);
    further.evaluations += end.outcome.evaluations;
    further.hessians += end.outcome.hessians;
    end.outcome = std::move(further);
    if (end.outcome.x.size() == 0) return end;
    Solution solution = assess(problem, design_at(chosen, end.outcome.x));
    if (preferred(problem, solution, *end.solution)) end.solution = std::move(solution);
    return end;
}

std::vector<Milestone> milestones_of(const Problem& problem, const std::vector<Slot>& slots) {
    std::vector<Milestone> all;
    Milestone so_far;
    for (const Slot& slot : slots) {
        so_far.screened += slot.counts.drawn;
        so_far.evaluations += slot.evaluations;
        so_far.hessians += slot.hessians;
        if (slot.solution && (!so_far.best || preferred(problem, *slot.solution, *so_far.best)))
            so_far.best = slot.solution;
        all.push_back(so_far);
    }
    return all;
}

void keep(const std::vector<Slot>& slots, SearchTrace& trace) {
    for (const Slot& slot : slots) {
        trace.cut_off += slot.done ? 0 : 1;
        trace.ends.insert(trace.ends.end(), slot.ends.begin(), slot.ends.end());
    }
}

}  // namespace

Multistart multistart(const Problem& problem, LocalMethod method, const RunOptions& options,
                      std::chrono::steady_clock::time_point deadline) {
    std::vector<Program> programs;
    for (const Variant& variant : variants(problem))
        programs.push_back(build_program(problem, variant));
    Multistart result;
    if (programs.empty()) return result;

    const int candidates = start_candidates(problem);
    const auto random_start = [&](const SearchTask& task) {
        const Timed timed(seconds_of(options.trace, &SearchTrace::screening));
        return screened_start(*task.program, problem.solver.seed, task.number, candidates, task.preferred);
    };
    std::vector<Start> firsts(has_many_assemblies(programs) ? programs.size() : 0);
    share_work(static_cast<int>(firsts.size()), options.jobs, [&](int i) {
        firsts[static_cast<std::size_t>(i)] = random_start({&programs[static_cast<std::size_t>(i)], 0, true});
    });
    std::vector<AssemblyMerit> merits;
    for (std::size_t i = 0; i < firsts.size(); ++i) {
        merits.push_back({programs[i].variant.assembly, firsts[i].merit});
        add_counts(result.report, firsts[i].counts);
    }
    const std::vector<std::size_t> kept = in_best_assemblies(programs, std::move(merits));

    // Of several components that may meet a requirement most designs have one that does: what is best without it often
    // meets it, too, and is sought first.
    const std::vector<Program> open = without_choices(problem, programs, kept);
    std::vector<const Program*> without, with;
    for (const Program& program : open)
        without.push_back(&program);
    for (const std::size_t i : kept)
        with.push_back(&programs[i]);
    const std::vector<SearchTask> tasks = search_tasks(problem, without, with);
    const auto total = static_cast<int>(tasks.size());
    LocalLimits limits;
    limits.deadline = deadline;
    limits.stop = options.stop;
    limits.polishing = seconds_of(options.trace, &SearchTrace::polishing);

    std::vector<Slot> slots(static_cast<std::size_t>(total));
    std::mutex reporting;
    int done = 0;
    std::optional<Solution> best;
    // The first start that ends at a zero that nothing can be below: those after it are not needed, those before it are
    // run, so that the answer does not depend on the threads.
    std::atomic<int> zero_at{total};
    const auto run = [&](std::string_view from, const auto& search) {
        done = 0;
        share_work(total, options.jobs, [&](int task) {
            if (limits.reached() || task > zero_at) return;
            const Program& program = *tasks[static_cast<std::size_t>(task)].program;
            Slot& slot = slots[static_cast<std::size_t>(task)];
            const Start start = random_start(tasks[static_cast<std::size_t>(task)]);
            slot.counts = start.counts;
            slot.counts.optimised = 1;
            slot.counts.preferred = start.preferred ? 1 : 0;
            const Timed timed(seconds_of(options.trace, &SearchTrace::searching));
            LocalEnd end = searched(program, start.x, search);
            slot.evaluations += end.outcome.evaluations;
            slot.hessians += end.outcome.hessians;
            if (end.solution) slot.solution = std::move(end.solution);
            slot.done = !limits.reached();
            if (options.trace)
                slot.ends.push_back({!from.empty()     ? from
                                     : start.preferred ? "preferred values"
                                                       : "screened",
                                     end.outcome.verdict, end.outcome.evaluations, timed.seconds(), slot.solution});
            if (slot.solution && is_at_zero(problem, *slot.solution))
                for (int before = zero_at; task < before && !zero_at.compare_exchange_weak(before, task);) {
                }
            if (!options.progress) return;
            const std::lock_guard lock(reporting);
            ++done;
            if (slot.solution && slot.solution->feasible && (!best || preferred(problem, *slot.solution, *best)))
                best = slot.solution;
            options.progress(done, total, best ? best->objective : std::numeric_limits<double>::quiet_NaN());
        });
    };
    run("",
        [&](const Program& program, const VectorXd& start) { return polished_search(program, start, method, limits); });
    const auto feasible = [](const Slot& slot) { return slot.solution && slot.solution->feasible; };
    if (std::none_of(slots.begin(), slots.end(), feasible) && !limits.reached())
        run("least shortfall", [&](const Program& program, const VectorXd& start) {
            return search_nearly_feasible(program, start, method, limits);
        });

    if (zero_at < total) {
        slots.resize(static_cast<std::size_t>(zero_at) + 1);
        result.report.proof = proof_by_zero(problem);
    }
    for (const Slot& slot : slots) {
        result.report.starts += slot.done ? 1 : 0;
        result.report.evaluations += slot.evaluations;
        add_counts(result.report, slot.counts);
        result.stopped = result.stopped || !slot.done;
    }
    if (options.trace) keep(slots, *options.trace);
    std::vector<const Solution*> found;
    for (const Slot& slot : slots)
        if (slot.solution) found.push_back(&*slot.solution);
    result.optima = distinct_optima(problem, found, result.report);
    if (result.report.proof) result.report.missed_chance = 0;
    result.milestones = milestones_of(problem, slots);
    return result;
}

}  // namespace mechwright
