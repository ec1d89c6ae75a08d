#include "synthesis/search/path/path_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

#include "synthesis/program/assess.h"
#include "synthesis/program/search_trace.h"
#include "synthesis/program/work_sharing.h"
#include "synthesis/program/zero_objective.h"
#include "synthesis/search/curve/curve_search.h"
#include "synthesis/search/optima.h"
#include "synthesis/search/path/known_parts.h"
#include "synthesis/search/path/path_objective.h"
#include "synthesis/search/path/path_rounds.h"
#include "synthesis/search/path/trials_about_parts.h"
#include "synthesis/search/polished_search.h"

namespace mechwright {

namespace {

using Eigen::VectorXd;

/// Objectives that agree to this part are one optimum.
constexpr double same_objective_within = 1e-6;
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
/// There are so many rounds, and as many times more as the problem asks for more starts than a round has.
constexpr int rounds_for_starts = 12;
/// Rounds and hits are so many times more where the best design comes so close to all points that one is likely to meet
/// them: that searches end elsewhere again and again is then no sign that there is none.
constexpr int times_more_near_zero = 3;

/// All the state of one run.
struct Search {
    const Problem& problem;
    const RunOptions& options;
    PathRounds rounds;
    std::vector<Solution> found{};
    std::optional<Solution> best{};
    std::optional<Solution> best_before{};  ///< when hits were counted last
    long hessians = 0;
    SearchEnds known_ends{same_sum_within};  ///< sums of squares of the searches from screened starts run to their end
    int hits = 0;                            ///< on the best so far
    int rounds_on_best = 0;                  ///< rounds that ended at the best so far
    double least_sum = unlimited;            ///< of a feasible design, by least squares alone
    int thoroughness;                        ///< so many times the starts of a round are asked for
    int most_rounds;
    int along_valley = evaluations_along_valley;

    Search(const Problem& p, const RunOptions& o, std::chrono::steady_clock::time_point deadline)
        : problem(p),
          options(o),
          rounds(p, o, deadline),
          thoroughness((p.solver.starts + most_starts_of_round - 1) / most_starts_of_round),
          most_rounds(rounds_for_starts * thoroughness) {}

    /// What another search came to: designs that this one is to do better than.
    void begin_with(const Multistart& other) {
        rounds.report = other.report;
        found = other.optima;
        if (!found.empty()) best = found.front();
    }

    /// Counts the searches from screened starts that ended at the least sum of squares of a feasible design, those of
    /// earlier rounds too; and the rounds that came to the best design, each of which goes its own way.
    void count_hits(const std::vector<Trial>& trials, const std::optional<Solution>& best_of_round) {
        if (!rounds.least_squares) hits = hits_on_best();
        for (const Trial& trial : trials)
            if (rounds.led && trial.from == TrialStart::drawn) known_ends.add(trial.outcome.objective);
        for (const Trial& trial : trials) {
            const double sum = trial.outcome.objective;
            if (!rounds.least_squares || sum > (1 + same_sum_within) * least_sum || !rounds.assessed(trial).feasible)
                continue;
            if (sum < (1 - same_sum_within) * least_sum) hits = 0;
            least_sum = std::min(least_sum, sum);
            if (trial.from == TrialStart::drawn) ++hits;
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

    /// How many times more is done than where no design is likely to meet every point.
    int times_more() const {
        const bool likely = rounds.may_end_early() && best && is_nearly_at_zero(problem, *best);
        return likely ? times_more_near_zero : 1;
    }

    int rounds_at_most() const { return times_more() * most_rounds; }

    bool enough(int rounds_done) const {
        if (best_is_exact() || rounds_done >= rounds_at_most()) return true;
        if (rounds_done < least_rounds) return false;
        if (rounds.led && problem.path->any_order && known_ends.unseen() > most_share_unseen) return false;
        const int times = times_more() * thoroughness;
        return hits >= enough_hits * times || (rounds.led && rounds_on_best >= enough_rounds_on_best * times);
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
        Solution solution = rounds.assessed(trial);
        const Program& program = rounds.programs.all[trial.program];
        if (rounds.least_squares && solution.feasible && program.size() > most_polished_variables) return solution;
        VectorXd x = point_of(program, solution.design);
        LocalLimits some = rounds.limits;
        if (program.size() > most_polished_variables) some.most_evaluations = evaluations_of_great_program;
        if (rounds.may_end_early()) {
            // Long valleys are what least squares that bend their steps get through, and slsqp does not.
            if (is_at_zero(problem, solution)) return solution;
            some.most_evaluations = along_valley;
            outcome = rounds.programs.long_search(trial.program, x, some);
            if (outcome.x.size() > 0)
                solution = better(std::move(solution), assess(problem, design_at(program, outcome.x)));
            if (solution.feasible) return solution;
            x = point_of(program, solution.design);
            some.most_evaluations = evaluations_of_great_program;
        }
        const long before = outcome.evaluations;
        outcome = polished_search(program, x, slsqp, some);
        outcome.evaluations += before;
        if (outcome.x.size() == 0) return solution;
        return better(std::move(solution), assess(problem, design_at(program, outcome.x)));
    }

    /// Where rounds leave feasible designs to least squares: the best, polished once all rounds are done.
    void polish_best() {
        if (!rounds.may_end_early() || !best || !best->feasible || best_is_exact()) return;
        for (const Program& program : rounds.programs.all) {
            if (program.variant.assembly != best->design.assembly || rounds.limits.reached()) continue;
            LocalLimits some = rounds.limits;
            some.most_evaluations = evaluations_of_great_program;
            const LocalOutcome outcome = polished_search(program, point_of(program, best->design), slsqp, some);
            rounds.report.evaluations += outcome.evaluations;
            hessians += outcome.hessians;
            if (outcome.x.size() == 0) continue;
            found.push_back(assess(problem, design_at(program, outcome.x)));
            if (preferred(problem, found.back(), *best)) best = found.back();
        }
    }

    static std::string_view origin_of(const Trial& trial) {
        switch (trial.from) {
            case TrialStart::about_part: return "about a four-bar";
            case TrialStart::nearby: return "near another end";
            case TrialStart::drawn: break;
        }
        return "screened";
    }

    /// The ends of a round in the order of its trials: those that were looked at closely, and the others as they are.
    void keep(const std::vector<Trial>& trials, const std::vector<const Trial*>& chosen,
              const std::vector<SearchEnd>& ends) const {
        std::size_t next = 0;
        for (const Trial& trial : trials) {
            const bool looked_at = next < chosen.size() && chosen[next] == &trial;
            options.trace->ends.push_back(looked_at
                                              ? ends[next]
                                              : SearchEnd{origin_of(trial), trial.outcome.verdict, trial.evaluations,
                                                          trial.seconds, rounds.assessed(trial)});
            next += looked_at ? 1 : 0;
        }
    }

    /// Polishes the best of a round; returns the best of them.
    std::optional<Solution> finish(const std::vector<Trial>& trials) {
        // Of searches that ended at one sum of squares the first few are looked at closely; the others are counted.
        const int most = rounds.least_squares ? most_polished
                         : rounds.led         ? most_polished_on
                                              : std::numeric_limits<int>::max();
        std::vector<const Trial*> chosen;
        std::vector<double> sums;
        for (const Trial& trial : trials) {
            if (static_cast<int>(chosen.size()) >= most) break;
            const double sum = trial.outcome.objective;
            const bool known = std::any_of(sums.begin(), sums.end(),
                                           [&](double s) { return std::abs(sum - s) <= same_sum_within * s; });
            if (known && rounds.led) continue;
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
            if (!rounds.limits.reached() || k == 0) solutions[k] = finished(*chosen[k], outcome);
            if (options.trace)
                ends[k] = {
                    origin_of(*chosen[k]), outcome.verdict.empty() ? chosen[k]->outcome.verdict : outcome.verdict,
                    chosen[k]->evaluations + outcome.evaluations, chosen[k]->seconds + timed.seconds(), solutions[k]};
            const std::lock_guard lock(reporting);
            rounds.report.evaluations += outcome.evaluations;
            hessians += outcome.hessians;
            if (solutions[k] && (!best || preferred(problem, *solutions[k], *best))) best = solutions[k];
            if (options.progress)
                options.progress(rounds.report.starts, rounds_at_most() * rounds.starts_of_round,
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

/// Puts feasible cognates of the best design among the optima, after those that are as good: they follow the path as
/// closely, may meet limits that it does not, and may be better in what is not asked for.
void add_cognates_of_best(const PathRounds& rounds, std::vector<Solution>& optima) {
    constexpr double as_good_within = 1e-9;  // it is the best that has been polished
    if (optima.empty()) return;
    const Solution best = optima.front();
    for (Solution& cognate : rounds.cognates_of_design(best.design)) {
        const bool known = std::any_of(optima.begin(), optima.end(), [&](const Solution& one) {
            return same_optimum(rounds.problem, one.design, cognate.design);
        });
        if (!cognate.feasible || known) continue;
        const bool as_good =
            best.feasible && std::abs(cognate.objective - best.objective) <= as_good_within * std::abs(best.objective);
        const auto at = std::find_if(optima.begin() + (as_good ? 1 : 0), optima.end(),
                                     [&](const Solution& one) { return preferred(rounds.problem, cognate, one); });
        optima.insert(at, std::move(cognate));
    }
}

/// The distinct designs that a search ended at, with the report of it.
void take_optima(Search& search, Multistart& result) {
    const Problem& problem = search.problem;
    // Beside a design that meets all points others that miss them are none to choose from.
    if (search.rounds.may_end_early() && search.best_is_exact())
        std::erase_if(search.found, [&](const Solution& s) { return !is_at_zero(problem, s); });
    std::vector<const Solution*> all;
    for (const Solution& s : search.found)
        all.push_back(&s);
    result.report = search.rounds.report;
    result.optima = distinct_optima(problem, all, result.report);
    add_cognates_of_best(search.rounds, result.optima);
    result.stopped = search.rounds.limits.reached();
    if (search.best_is_exact()) result.report.proof = proof_by_zero(problem);
}

}  // namespace

std::string why_no_path_search(const Problem& problem) {
    if (!problem.path) return "the problem has no [path]";
    return {};
}

Multistart path_search(const Problem& problem, const RunOptions& options,
                       std::chrono::steady_clock::time_point deadline) {
    Multistart by_curves;
    if (can_search_curves(problem)) {
        by_curves = curve_search(problem, options, deadline);
        const bool feasible = !by_curves.optima.empty() && by_curves.optima.front().feasible;
        if (by_curves.stopped || (feasible && least_squares_suffice(problem))) return by_curves;
    }
    Multistart result;
    Search search(problem, options, deadline);
    if (search.rounds.programs.all.empty()) return by_curves;
    search.begin_with(by_curves);
    for (int round = 0; !search.rounds.limits.reached(); ++round) {
        const std::vector<Trial> trials = search.rounds.trials_of(round);
        const std::optional<Solution> best_of_round = search.finish(trials);
        search.count_hits(trials, best_of_round);
        result.milestones.push_back(
            {search.rounds.report.drawn, search.rounds.report.evaluations, search.hessians, search.best});
        if (search.enough(round + 1)) break;
    }
    search.polish_best();
    take_optima(search, result);
    if (search.rounds.least_squares) result.report.hits = std::max(result.report.hits, search.hits);
    if (search.rounds.led && problem.path->any_order) result.report.missed_chance = search.known_ends.unseen();
    if (!by_curves.optima.empty())
        result.report.missed_chance = std::max(result.report.missed_chance, by_curves.report.missed_chance);
    if (search.best_is_exact()) result.report.missed_chance = 0;
    return result;
}

Multistart path_search_about_parts(const Problem& problem, const RunOptions& options,
                                   std::chrono::steady_clock::time_point deadline, long budget) {
    Multistart result;
    if (!has_guiding_part(problem)) return result;
    Search search(problem, options, deadline);
    const std::vector<Trial> trials = trials_about_parts(search.rounds, budget);
    search.rounds.report.starts = static_cast<int>(trials.size());
    if (!trials.empty())
        search.along_valley = static_cast<int>(
            std::clamp((budget - search.rounds.report.evaluations) / static_cast<long>(trials.size()),
                       static_cast<long>(evaluations_of_great_program), static_cast<long>(evaluations_along_valley)));
    search.finish(trials);
    search.polish_best();
    take_optima(search, result);
    return result;
}

}  // namespace mechwright
