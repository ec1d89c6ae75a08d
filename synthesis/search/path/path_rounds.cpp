#include "synthesis/search/path/path_rounds.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/search_trace.h"
#include "synthesis/program/work_sharing.h"
#include "synthesis/program/zero_objective.h"
#include "synthesis/search/best_assemblies.h"
#include "synthesis/search/path/cognate_starts.h"
#include "synthesis/search/path/path_objective.h"
#include "synthesis/search/path/path_timing.h"
#include "synthesis/search/starts_nearby.h"
#include "synthesis/target/path/rows/nearest_point.h"

namespace mechwright {

namespace {

using Eigen::VectorXd;

/// Groups of eight candidates screened for each short search, and the short searches for each one that is run to its
/// end.
constexpr int groups_per_short_search = 24;
constexpr int short_searches_per_start = 6;
/// So many tasks of short searches at a time; after them it is seen whether the best comes to all points exactly.
constexpr int tasks_of_wave = 4;
constexpr int looked_at_in_wave = 2;
/// Of the searches of a round so many are the best that are run to the very end.
constexpr std::size_t most_whole_searches = 12;
/// Times that the points of a path in any order are matched anew with the nearest points of the curve.
constexpr int most_passes = 4;
/// The best designs that a round ended at are gone on from to others nearby, in so many hops of so many starts each,
/// which spread over these parts of the dimensions.
constexpr int hops = 3;
constexpr int starts_of_hop = 6;
constexpr std::array<double, hops> spreads{0.1, 0.3, 0.6};
constexpr int evaluations_of_hop = 40;
constexpr std::size_t most_hops_run_to_end = 6;

}  // namespace

PathRounds::PathRounds(const Problem& p, const RunOptions& o, std::chrono::steady_clock::time_point deadline)
    : problem(p),
      options(o),
      programs(p),
      least_squares(least_squares_suffice(p)),
      led(least_squares || least_squares_lead_on(p)),
      starts_of_round(std::min(p.solver.starts, most_starts_of_round)) {
    for (const Program& program : programs.all)
        starts.emplace_back(program, p.solver.seed);
    searched.resize(programs.all.size());
    std::iota(searched.begin(), searched.end(), 0);
    limits.deadline = deadline;
    limits.stop = o.stop;
    limits.polishing = seconds_of(o.trace, &SearchTrace::polishing);
}

std::vector<Trial> PathRounds::trials_of(int round) {
    std::vector<Trial> trials = short_searches(round);
    if (round == 0 && !met_exactly) keep_best_assemblies(trials);
    if (met_exactly) trials.resize(1);
    keep_different(trials, starts_of_round);
    report.starts += static_cast<int>(trials.size());
    if (led && !met_exactly) {
        run_to_end(trials);
        if (!best_meets_all(trials)) search_nearby(round, trials);
    }
    return trials;
}

std::vector<VectorXd> PathRounds::screened(std::size_t program, int number, int keep, DrawCounts& counts) const {
    const Timed timed(seconds_of(options.trace, &SearchTrace::screening));
    return starts[program].of_round(number, keep * groups_per_short_search, keep, counts);
}

Trial PathRounds::short_trial(std::size_t program, const VectorXd& start, TrialStart from, int evaluations) const {
    const Timed timed(seconds_of(options.trace, &SearchTrace::searching));
    LocalLimits few = limits;
    few.most_evaluations = evaluations;
    Trial trial{program, programs.short_search(program, start, few), from};
    trial.evaluations = trial.outcome.evaluations;
    trial.seconds = timed.seconds();
    return trial;
}

std::vector<Trial> PathRounds::short_searches(int round) {
    const auto variants_count = static_cast<int>(searched.size());
    const int each = std::max(1, short_searches_per_start * starts_of_round / variants_count);
    // Tasks of a few starts each, so that the work can be shared evenly.
    constexpr int per_task = 4;
    const int tasks_per_variant = (each + per_task - 1) / per_task;
    const int tasks = tasks_per_variant * variants_count;
    std::vector<std::vector<Trial>> tried(static_cast<std::size_t>(tasks));
    std::vector<DrawCounts> counts(static_cast<std::size_t>(tasks));
    std::vector<Trial> all;
    const int of_wave = may_end_early() ? tasks_of_wave : tasks;
    for (int first = 0; first < tasks && !met_exactly; first += of_wave) {
        share_work(std::min(of_wave, tasks - first), options.jobs, [&](int i) {
            if (limits.reached()) return;
            const int task = first + i;
            const std::size_t p = searched[static_cast<std::size_t>(task % variants_count)];
            const int number = round * tasks_per_variant + task / variants_count;
            for (const VectorXd& start : screened(p, number, per_task, counts[static_cast<std::size_t>(task)])) {
                ++counts[static_cast<std::size_t>(task)].optimised;
                Trial trial = short_trial(programs.fitted_as[p], start, TrialStart::drawn, evaluations_of_short_search);
                if (trial.outcome.x.size() > 0) tried[static_cast<std::size_t>(task)].push_back(std::move(trial));
            }
        });
        std::vector<Trial> wave;
        for (int task = first; task < std::min(first + of_wave, tasks); ++task) {
            auto& some = tried[static_cast<std::size_t>(task)];
            std::move(some.begin(), some.end(), std::back_inserter(wave));
        }
        met_exactly = may_end_early() && ends_at_zero(wave);
        std::move(wave.begin(), wave.end(), std::back_inserter(all));
    }
    sort_by_sum(all);
    for (const Trial& trial : all)
        report.evaluations += trial.evaluations;
    for (const DrawCounts& of_task : counts)
        add_counts(report, of_task);
    return all;
}

/// The searches that began in the best assemblies, where there are many; others are not searched any more.
void PathRounds::keep_best_assemblies(std::vector<Trial>& trials) {
    std::vector<AssemblyMerit> merits;
    for (const Trial& trial : trials)
        merits.push_back({programs.all[trial.program].variant.assembly, trial.outcome.objective});
    searched = in_best_assemblies(programs.all, std::move(merits));
    std::erase_if(trials, [&](const Trial& trial) {
        return !std::binary_search(searched.begin(), searched.end(), trial.program);
    });
}

/// Whether the best of some short searches, taken farther, comes to all points exactly: then nothing else is looked
/// for.
bool PathRounds::ends_at_zero(std::vector<Trial>& wave) const {
    sort_by_sum(wave);
    LocalLimits some = limits;
    some.most_evaluations = evaluations_of_long_search;
    share_work(std::min(looked_at_in_wave, static_cast<int>(wave.size())), options.jobs, [&](int i) {
        Trial& trial = wave[static_cast<std::size_t>(i)];
        LocalOutcome outcome = programs.long_search(trial.program, trial.outcome.x, some);
        trial.evaluations += outcome.evaluations;
        if (outcome.x.size() > 0) trial.outcome = std::move(outcome);
    });
    sort_by_sum(wave);
    return best_meets_all(wave);
}

/// Whether the first of sorted trials comes to all points exactly, where the round can end with that.
bool PathRounds::best_meets_all(const std::vector<Trial>& sorted) const {
    return may_end_early() && !sorted.empty() && is_at_zero(problem, assessed(sorted.front()));
}

/// The most promising ones run to their end, best first.
void PathRounds::run_to_end(std::vector<Trial>& trials) {
    go_on(trials, evaluations_of_long_search);
    trials.resize(std::min(trials.size(), most_whole_searches));
    go_on(trials, evaluations_of_whole_search);
}

std::vector<Solution> PathRounds::cognates_of_design(const Design& design) const {
    std::vector<Solution> all;
    for (std::size_t p = 0; p < programs.all.size(); ++p) {
        if (programs.all[p].variant.assembly != design.assembly) continue;
        for (const PointOfProgram& point : cognates_of(programs.all, p, point_of(programs.all[p], design)))
            all.push_back(assess(problem, design_at(programs.all[point.program], point.x)));
    }
    return all;
}

void PathRounds::search_nearby(int round, std::vector<Trial>& trials, long until) {
    std::vector<Trial> elites = elites_of(trials);
    for (int hop = 0; hop < hops && !elites.empty() && !limits.reached(); ++hop) {
        if (report.evaluations >= until) break;
        std::vector<Trial> tried(elites.size() * starts_of_hop);
        share_work(static_cast<int>(tried.size()), options.jobs, [&](int i) {
            if (limits.reached()) return;
            const auto k = static_cast<std::size_t>(i);
            const Trial& from = elites[k / starts_of_hop];
            const std::uint64_t number = mixed(problem.solver.seed + static_cast<std::uint64_t>(round * hops + hop));
            const Program& program = programs.all[from.program];
            const VectorXd start = start_nearby(program, from.outcome.x, spreads[k % hops], mixed(number + k));
            tried[k] = short_trial(from.program, start, TrialStart::nearby, evaluations_of_hop);
        });
        for (const Trial& trial : tried)
            report.evaluations += trial.outcome.evaluations;
        std::erase_if(tried, [](const Trial& t) { return t.outcome.x.size() == 0; });
        report.sources.nearby += static_cast<long>(tried.size());
        sort_by_sum(tried);
        keep_different(tried, starts_of_round);
        tried.resize(std::min(tried.size(), most_hops_run_to_end));
        go_on(tried, evaluations_of_whole_search);
        trials.insert(trials.end(), tried.begin(), tried.end());
        sort_by_sum(trials);
        const double least_before = elites.front().outcome.objective;
        elites = elites_of(trials);
        if (best_meets_all(trials)) break;
        const bool gained = elites.front().outcome.objective < (1 - same_sum_within) * least_before;
        if (!gained && hop > 0) break;
    }
}

void PathRounds::go_on(std::vector<Trial>& trials, int evaluations) {
    LocalLimits whole = limits;
    whole.most_evaluations = evaluations;
    std::vector<long> used(trials.size(), 0);
    share_work(static_cast<int>(trials.size()), options.jobs, [&](int i) {
        Trial& trial = trials[static_cast<std::size_t>(i)];
        if (limits.reached()) return;
        const Timed timed(seconds_of(options.trace, &SearchTrace::searching));
        const Program& program = programs.all[trial.program];
        for (int pass = 0; pass < (problem.path->any_order ? most_passes : 1); ++pass) {
            if (trial.outcome.x.size() == 0) break;
            LocalOutcome outcome = programs.long_search(trial.program, trial.outcome.x, whole);
            used[static_cast<std::size_t>(i)] += outcome.evaluations;
            if (outcome.x.size() == 0) break;
            const bool settled = pass > 0 && outcome.objective > (1 - same_sum_within) * trial.outcome.objective;
            trial.outcome = std::move(outcome);
            if (!problem.path->any_order || settled) break;
            Design design = design_at(program, trial.outcome.x);
            meet_nearest_points(problem, design);
            trial.outcome.x = point_of(program, design);
        }
        trial.evaluations += used[static_cast<std::size_t>(i)];
        trial.seconds += timed.seconds();
    });
    report.evaluations += std::accumulate(used.begin(), used.end(), 0L);
    sort_by_sum(trials);
}

/// Least squares leave whole cycles of crank angles as they were drawn: where those put points out of their order, the
/// same poses in it, whichever way the crank turns.
Solution PathRounds::assessed(const Trial& trial) const {
    const Program& program = programs.all[trial.program];
    Solution best = assess(problem, design_at(program, trial.outcome.x));
    if (best.feasible || problem.path->any_order || !program.untimed_path()) return best;
    const Design as_found = best.design;
    for (const int direction : {1, -1}) {
        Design in_order = as_found;
        meet_in_order(problem, direction, in_order);
        Solution ordered = assess(problem, std::move(in_order));
        if (preferred(problem, ordered, best)) best = std::move(ordered);
    }
    return best;
}

}  // namespace mechwright
