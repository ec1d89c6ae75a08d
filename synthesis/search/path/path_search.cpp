#include "synthesis/search/path/path_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/search_trace.h"
#include "synthesis/program/work_sharing.h"
#include "synthesis/program/zero_objective.h"
#include "synthesis/search/best_assemblies.h"
#include "synthesis/search/curve/curve_search.h"
#include "synthesis/search/optima.h"
#include "synthesis/search/path/path_objective.h"
#include "synthesis/search/path/path_programs.h"
#include "synthesis/search/path/path_trials.h"
#include "synthesis/search/polished_search.h"
#include "synthesis/search/screened_starts.h"
#include "synthesis/search/starts_nearby.h"
#include "synthesis/target/path/rows/nearest_point.h"

namespace mechwright {

namespace {

using Eigen::VectorXd;

/// Groups of eight candidates screened for each short search, and the short searches for each one that is run to its
/// end.
constexpr int groups_per_short_search = 24;
constexpr int short_searches_per_start = 6;
constexpr int evaluations_of_short_search = 25;
/// So many tasks of short searches at a time; after them it is seen whether the best comes to all points exactly.
constexpr int tasks_of_wave = 4;
constexpr int looked_at_in_wave = 2;
constexpr int evaluations_of_long_search = 100;
constexpr int evaluations_of_whole_search = 600;
/// Of the searches of a round so many are the best that are run to the very end.
constexpr std::size_t most_whole_searches = 12;
/// Sums of squares that agree to this part are taken for the same optimum before it is looked at closely.
constexpr double same_sum_within = 1e-3;
/// Times that the points of a path in any order are matched anew with the nearest points of the curve.
constexpr int most_passes = 4;
/// Objectives that agree to this part are one optimum.
constexpr double same_objective_within = 1e-6;
/// The best designs that a round ended at are gone on from to others nearby, in so many hops of so many starts each,
/// which spread over these parts of the dimensions.
constexpr int hops = 3;
constexpr int starts_of_hop = 6;
constexpr std::array<double, hops> spreads{0.1, 0.3, 0.6};
constexpr int evaluations_of_hop = 40;
constexpr std::size_t most_hops_run_to_end = 6;
/// Optima of a round that are polished, where least squares are the objective and where they lead to it; and the
/// greatest program for which the polish is quick.
constexpr int most_polished = 4;
constexpr int most_polished_on = 8;
constexpr std::size_t most_polished_variables = 60;
constexpr int evaluations_of_great_program = 60;
/// Where a few points hardly hold a design, the way along a valley to where all are met takes thousands.
constexpr int evaluations_along_valley = 6000;
/// The search ends once the best design was hit this often, or so many rounds came to it, each by itself; as many times
/// more as the problem asks for more starts; and not before this many rounds.
constexpr int enough_hits = 10;
constexpr int enough_rounds_on_best = 3;
constexpr int least_rounds = 2;
/// Of a path in any order, whose optima are many, it goes on while more than this share of searches would end at
/// optima that are not known.
constexpr double most_share_unseen = 0.05;
/// A round has as many starts as the problem asks for, but no more than this; and with them come so many rounds.
constexpr int most_starts_of_round = 32;
constexpr int rounds_for_starts = 12;

/// All the state of one run.
struct Search {
    const Problem& problem;
    const RunOptions& options;
    PathPrograms programs;
    std::vector<ScreenedStarts> starts;  ///< by program
    std::vector<std::size_t> searched;   ///< of the programs, those in which starts are screened
    LocalLimits limits;
    bool least_squares;  ///< the sum of squares is all that counts
    bool led;            ///< least squares lead to the objective
    std::vector<Solution> found;
    std::optional<Solution> best;
    std::optional<Solution> best_before;  ///< when hits were counted last
    SearchReport report;
    long hessians = 0;
    SearchEnds known_ends{same_sum_within};  ///< sums of squares of the searches from screened starts run to their end
    int hits = 0;                            ///< on the best so far
    int rounds_on_best = 0;                  ///< rounds that ended at the best so far
    double least_sum = unlimited;            ///< of a feasible design, by least squares alone
    bool met_exactly = false;                ///< a short search came to all points exactly
    int starts_of_round;
    int thoroughness;  ///< so many times the starts of a round are asked for
    int most_rounds;

    Search(const Problem& p, const RunOptions& o, std::chrono::steady_clock::time_point deadline)
        : problem(p),
          options(o),
          programs(p),
          least_squares(least_squares_suffice(p)),
          led(least_squares || least_squares_lead_on(p)),
          starts_of_round(std::min(p.solver.starts, most_starts_of_round)),
          thoroughness((p.solver.starts + most_starts_of_round - 1) / most_starts_of_round),
          most_rounds(rounds_for_starts * thoroughness) {
        for (const Program& program : programs.all)
            starts.emplace_back(program, p.solver.seed);
        searched.resize(programs.all.size());
        std::iota(searched.begin(), searched.end(), 0);
        limits.deadline = deadline;
        limits.stop = o.stop;
        limits.polishing = seconds_of(o.trace, &SearchTrace::polishing);
    }

    std::vector<VectorXd> screened(std::size_t program, int number, int keep, DrawCounts& counts) const {
        const Timed timed(seconds_of(options.trace, &SearchTrace::screening));
        return starts[program].of_round(number, keep * groups_per_short_search, keep, counts);
    }

    /// The best starts of every variant, each taken a little way.
    std::vector<Trial> short_searches(int round) {
        const auto variants_count = static_cast<int>(searched.size());
        const int each = std::max(1, short_searches_per_start * starts_of_round / variants_count);
        // Tasks of a few starts each, so that the work can be shared evenly.
        constexpr int per_task = 4;
        const int tasks_per_variant = (each + per_task - 1) / per_task;
        const int tasks = tasks_per_variant * variants_count;
        std::vector<std::vector<Trial>> tried(static_cast<std::size_t>(tasks));
        std::vector<DrawCounts> counts(static_cast<std::size_t>(tasks));
        LocalLimits few = limits;
        few.most_evaluations = evaluations_of_short_search;
        std::vector<Trial> all;
        const int of_wave = may_end_early() ? tasks_of_wave : tasks;
        for (int first = 0; first < tasks && !met_exactly; first += of_wave) {
            share_work(std::min(of_wave, tasks - first), options.jobs, [&](int i) {
                if (limits.reached()) return;
                const int task = first + i;
                const std::size_t p = searched[static_cast<std::size_t>(task % variants_count)];
                const int number = round * tasks_per_variant + task / variants_count;
                for (const VectorXd& start : screened(p, number, per_task, counts[static_cast<std::size_t>(task)])) {
                    const Timed timed(seconds_of(options.trace, &SearchTrace::searching));
                    const std::size_t as = programs.fitted_as[p];
                    Trial trial{as, programs.short_search(as, start, few)};
                    trial.evaluations = trial.outcome.evaluations;
                    trial.seconds = timed.seconds();
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
        for (const DrawCounts& of_task : counts) {
            report.drawn += of_task.drawn;
            report.assembled += of_task.assembled;
        }
        report.optimised += static_cast<long>(all.size());
        return all;
    }

    /// The searches that began in the best assemblies, where there are many; others are not searched any more.
    void keep_best_assemblies(std::vector<Trial>& trials) {
        std::vector<AssemblyMerit> merits;
        for (const Trial& trial : trials)
            merits.push_back({programs.all[trial.program].variant.assembly, trial.outcome.objective});
        searched = in_best_assemblies(programs.all, std::move(merits));
        std::erase_if(trials, [&](const Trial& trial) {
            return !std::binary_search(searched.begin(), searched.end(), trial.program);
        });
    }

    /// Whether a round can end at the first search that comes to all points exactly.
    bool may_end_early() const { return least_squares && programs.skip_margins(); }

    /// Whether the best of some short searches, taken farther, comes to all points exactly: then nothing else is looked
    /// for.
    bool ends_at_zero(std::vector<Trial>& wave) const {
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
    bool best_meets_all(const std::vector<Trial>& sorted) const {
        return may_end_early() && !sorted.empty() && is_at_zero(problem, assessed(sorted.front()));
    }

    /// The most promising ones run to their end, best first.
    void run_to_end(std::vector<Trial>& trials) {
        go_on(trials, evaluations_of_long_search);
        trials.resize(std::min(trials.size(), most_whole_searches));
        go_on(trials, evaluations_of_whole_search);
    }

    /// Goes on from the best of a round to starts nearby, and from what is better there; adds what it comes to.
    void search_nearby(int round, std::vector<Trial>& trials) {
        std::vector<Trial> elites = elites_of(trials);
        for (int hop = 0; hop < hops && !elites.empty() && !limits.reached(); ++hop) {
            std::vector<Trial> tried(elites.size() * starts_of_hop);
            LocalLimits few = limits;
            few.most_evaluations = evaluations_of_hop;
            share_work(static_cast<int>(tried.size()), options.jobs, [&](int i) {
                if (limits.reached()) return;
                const Timed timed(seconds_of(options.trace, &SearchTrace::searching));
                const auto k = static_cast<std::size_t>(i);
                const Trial& from = elites[k / starts_of_hop];
                const std::uint64_t number =
                    mixed(problem.solver.seed + static_cast<std::uint64_t>(round * hops + hop));
                const Program& program = programs.all[from.program];
                const VectorXd start = start_nearby(program, from.outcome.x, spreads[k % hops], mixed(number + k));
                tried[k] = {from.program, programs.short_search(from.program, start, few), true};
                tried[k].evaluations = tried[k].outcome.evaluations;
                tried[k].seconds = timed.seconds();
            });
            for (const Trial& trial : tried)
                report.evaluations += trial.outcome.evaluations;
            std::erase_if(tried, [](const Trial& t) { return t.outcome.x.size() == 0; });
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

    /// All of them taken farther, best first.
    void go_on(std::vector<Trial>& trials, int evaluations) {
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

    Solution assessed(const Trial& trial) const {
        return assess(problem, design_at(programs.all[trial.program], trial.outcome.x));
    }

    /// Counts the searches from screened starts that ended at the least sum of squares of a feasible design, those of
    /// earlier rounds too; and the rounds that came to the best design, each of which goes its own way.
    void count_hits(const std::vector<Trial>& trials, const std::optional<Solution>& best_of_round) {
        if (!least_squares) hits = hits_on_best();
        for (const Trial& trial : trials)
            if (led && !trial.nearby) known_ends.add(trial.outcome.objective);
        for (const Trial& trial : trials) {
            const double sum = trial.outcome.objective;
            if (!least_squares || sum > (1 + same_sum_within) * least_sum || !assessed(trial).feasible) continue;
            if (sum < (1 - same_sum_within) * least_sum) hits = 0;
            least_sum = std::min(least_sum, sum);
            if (!trial.nearby) ++hits;
        }
        if (!best || !best->feasible || !best_of_round) return;
        if (best_before && !as_good_as_best(*best_before)) rounds_on_best = 0;
        best_before = best;
        if (as_good_as_best(*best_of_round)) ++rounds_on_best;
    }

    bool as_good_as_best(const Solution& s) const {
        return s.feasible &&
               std::abs(s.objective - best->objective) <= same_objective_within * std::abs(best->objective);
    }

    /// Whether the best design meets every point to rounding: then no other is better.
    bool best_is_exact() const { return best && is_at_zero(problem, *best); }

    bool enough(int rounds) const {
        if (best_is_exact()) return true;
        if (rounds < least_rounds) return false;
        if (led && problem.path->any_order && known_ends.unseen() > most_share_unseen) return false;
        return hits >= enough_hits * thoroughness || (led && rounds_on_best >= enough_rounds_on_best * thoroughness);
    }

    /// How many solutions are as good as the best.
    int hits_on_best() const {
        if (!best || !best->feasible) return 0;
        return static_cast<int>(
            std::count_if(found.begin(), found.end(), [&](const Solution& s) { return as_good_as_best(s); }));
    }

    Solution better(Solution a, Solution b) const { return preferred(problem, b, a) ? std::move(b) : std::move(a); }

    /// The solution near what the method of least squares ended at.
    Solution finished(const Trial& trial, LocalOutcome& outcome) const {
        Solution solution = assessed(trial);
        const Program& program = programs.all[trial.program];
        if (least_squares && solution.feasible && program.size() > most_polished_variables) return solution;
        VectorXd x = point_of(program, solution.design);
        LocalLimits some = limits;
        if (program.size() > most_polished_variables) some.most_evaluations = evaluations_of_great_program;
        if (may_end_early()) {
            // Long valleys are what least squares that bend their steps get through, and slsqp does not.
            if (is_at_zero(problem, solution)) return solution;
            some.most_evaluations = evaluations_along_valley;
            outcome = programs.long_search(trial.program, x, some);
            if (outcome.x.size() > 0)
                solution = better(std::move(solution), assess(problem, design_at(program, outcome.x)));
            if (is_at_zero(problem, solution)) return solution;
            x = point_of(program, solution.design);
            some.most_evaluations = evaluations_of_great_program;
        }
        const long before = outcome.evaluations;
        outcome = polished_search(program, x, slsqp, some);
        outcome.evaluations += before;
        if (outcome.x.size() == 0) return solution;
        return better(std::move(solution), assess(problem, design_at(program, outcome.x)));
    }

    static std::string_view origin_of(const Trial& trial) { return trial.nearby ? "near another end" : "screened"; }

    /// The ends of a round in the order of its trials: those that were looked at closely, and the others as they are.
    void keep(const std::vector<Trial>& trials, const std::vector<const Trial*>& chosen,
              const std::vector<SearchEnd>& ends) const {
        std::size_t next = 0;
        for (const Trial& trial : trials) {
            const bool looked_at = next < chosen.size() && chosen[next] == &trial;
            options.trace->ends.push_back(looked_at ? ends[next]
                                                    : SearchEnd{origin_of(trial), trial.outcome.verdict,
                                                                trial.evaluations, trial.seconds, assessed(trial)});
            next += looked_at ? 1 : 0;
        }
    }

    /// Polishes the best of a round; returns the best of them.
    std::optional<Solution> finish(const std::vector<Trial>& trials) {
        // Of searches that ended at one sum of squares the first few are looked at closely; the others are counted.
        const int most = least_squares ? most_polished : led ? most_polished_on : std::numeric_limits<int>::max();
        std::vector<const Trial*> chosen;
        std::vector<double> sums;
        for (const Trial& trial : trials) {
            if (static_cast<int>(chosen.size()) >= most) break;
            const double sum = trial.outcome.objective;
            const bool known = std::any_of(sums.begin(), sums.end(),
                                           [&](double s) { return std::abs(sum - s) <= same_sum_within * s; });
            if (known && led) continue;
            sums.push_back(sum);
            chosen.push_back(&trial);
        }
        std::vector<std::optional<Solution>> solutions(chosen.size());
        std::vector<SearchEnd> ends(options.trace ? chosen.size() : 0);
        std::mutex reporting;
        share_work(static_cast<int>(chosen.size()), options.jobs, [&](int i) {
            const auto k = static_cast<std::size_t>(i);
            const Timed timed(seconds_of(options.trace, &SearchTrace::searching));
            LocalOutcome outcome;
            if (!limits.reached() || k == 0) solutions[k] = finished(*chosen[k], outcome);
            if (options.trace)
                ends[k] = {
                    origin_of(*chosen[k]), outcome.verdict.empty() ? chosen[k]->outcome.verdict : outcome.verdict,
                    chosen[k]->evaluations + outcome.evaluations, chosen[k]->seconds + timed.seconds(), solutions[k]};
            const std::lock_guard lock(reporting);
            report.evaluations += outcome.evaluations;
            hessians += outcome.hessians;
            if (solutions[k] && (!best || preferred(problem, *solutions[k], *best))) best = solutions[k];
            if (options.progress)
                options.progress(report.starts, most_rounds * starts_of_round,
                                 best && best->feasible ? best->objective : std::numeric_limits<double>::quiet_NaN());
        });
        if (options.trace) keep(trials, chosen, ends);
        std::optional<Solution> best_of_round;
        for (auto& solution : solutions) {
            if (!solution) continue;
            if (!best_of_round || preferred(problem, *solution, *best_of_round)) best_of_round = solution;
            found.push_back(std::move(*solution));
        }
        return best_of_round;
    }
};

}  // namespace

std::string why_no_path_search(const Problem& problem) {
    if (!problem.path) return "the problem has no [path]";
    return {};
}

Multistart path_search(const Problem& problem, const RunOptions& options,
                       std::chrono::steady_clock::time_point deadline) {
    if (can_search_curves(problem)) {
        Multistart by_curves = curve_search(problem, options, deadline);
        const bool feasible = !by_curves.optima.empty() && by_curves.optima.front().feasible;
        if (feasible || by_curves.stopped) return by_curves;
    }
    Multistart result;
    Search search(problem, options, deadline);
    if (search.programs.all.empty()) return result;
    for (int round = 0; round < search.most_rounds && !search.limits.reached(); ++round) {
        std::vector<Trial> trials = search.short_searches(round);
        if (round == 0 && !search.met_exactly) search.keep_best_assemblies(trials);
        if (search.met_exactly) trials.resize(1);
        keep_different(trials, search.starts_of_round);
        search.report.starts += static_cast<int>(trials.size());
        if (search.led && !search.met_exactly) {
            search.run_to_end(trials);
            if (!search.best_meets_all(trials)) search.search_nearby(round, trials);
        }
        const std::optional<Solution> best_of_round = search.finish(trials);
        search.count_hits(trials, best_of_round);
        result.milestones.push_back({search.report.drawn, search.report.evaluations, search.hessians, search.best});
        if (search.enough(round + 1)) break;
    }
    // Beside a design that meets all points others that miss them are none to choose from.
    if (search.may_end_early() && search.best_is_exact())
        std::erase_if(search.found, [&](const Solution& s) { return !is_at_zero(problem, s); });
    std::vector<const Solution*> all;
    for (const Solution& s : search.found)
        all.push_back(&s);
    result.report = search.report;
    result.optima = distinct_optima(problem, all, result.report);
    if (search.least_squares) result.report.hits = std::max(result.report.hits, search.hits);
    if (search.led && problem.path->any_order) result.report.missed_chance = search.known_ends.unseen();
    result.stopped = search.limits.reached();
    if (search.best_is_exact()) {
        result.report.proof = proof_by_zero(problem);
        result.report.missed_chance = 0;
    }
    return result;
}

}  // namespace mechwright
