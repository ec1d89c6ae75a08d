#include "synthesis/search/path/trials_about_parts.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "synthesis/program/work_sharing.h"
#include "synthesis/search/drawn_starts.h"
#include "synthesis/search/path/known_parts.h"

namespace mechwright {

namespace {

/// Of all evaluations one in so many goes to the four-bars alone; of what is left one to short searches; and of what
/// these leave one to taking the most promising of them farther. What is left then is for running the best to their
/// end, which hardly ever takes so many, and for looking nearby.
constexpr long part_for_four_bars = 4;
constexpr long part_for_short_searches = 3;
constexpr long part_for_long_searches = 3;
/// A task has so many starts, each of which is the best of so many candidates that assemble.
constexpr int starts_of_part_task = 4;
constexpr int candidates_about_part = 40;
constexpr int most_drawn_about_part = 20 * candidates_about_part;
constexpr std::size_t most_part_tasks = 128;
/// So many of those that were run to their end are looked at closely.
constexpr std::size_t most_kept_about_parts = 3;

struct TaskAboutParts {
    std::size_t program;
    int round;
    DrawCounts counts{};
    std::vector<Trial> trials{};
};

void search_about_parts(const PathRounds& rounds, const DrawnStarts& starts, TaskAboutParts& task) {
    for (const Eigen::VectorXd& start :
         starts.of_round(task.round, starts_of_part_task, candidates_about_part, most_drawn_about_part, task.counts)) {
        if (rounds.limits.reached()) return;
        ++task.counts.optimised;
        Trial trial = rounds.short_trial(rounds.programs.fitted_as[task.program], start, TrialStart::about_part,
                                         evaluations_of_short_search);
        if (trial.outcome.x.size() > 0) task.trials.push_back(std::move(trial));
    }
}

/// Short searches of all programs that have parts, in turn.
std::vector<Trial> short_searches_about(PathRounds& rounds, std::vector<std::vector<KnownPart>> parts, long budget) {
    std::vector<DrawnStarts> starts;
    std::vector<std::size_t> programs;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].empty()) continue;
        programs.push_back(p);
        starts.emplace_back(rounds.programs.all[p], rounds.problem.solver.seed, std::move(parts[p]));
    }
    if (programs.empty()) return {};
    constexpr long evaluations_of_task = starts_of_part_task * evaluations_of_short_search;
    const std::size_t count = std::min(most_part_tasks, static_cast<std::size_t>(budget / evaluations_of_task));
    std::vector<TaskAboutParts> tasks;
    for (std::size_t i = 0; i < count; ++i)
        tasks.push_back({programs[i % programs.size()], static_cast<int>(i / programs.size())});
    share_work(static_cast<int>(tasks.size()), rounds.options.jobs, [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        if (!rounds.limits.reached()) search_about_parts(rounds, starts[k % programs.size()], tasks[k]);
    });
    std::vector<Trial> all;
    for (TaskAboutParts& task : tasks) {
        add_counts(rounds.report, task.counts, &StartSources::four_bars);
        for (const Trial& trial : task.trials)
            rounds.report.evaluations += trial.evaluations;
        std::move(task.trials.begin(), task.trials.end(), std::back_inserter(all));
    }
    sort_by_sum(all);
    return all;
}

void keep_first_trials(std::vector<Trial>& trials, std::size_t most) { trials.resize(std::min(trials.size(), most)); }

}  // namespace

std::vector<Trial> trials_about_parts(PathRounds& rounds, long budget) {
    if (!rounds.led) return {};
    long& used = rounds.report.evaluations;
    const long end = used + budget;
    const auto left = [&] { return std::max(end - used, 0L); };
    std::vector<std::vector<KnownPart>> parts = known_parts(rounds.problem, rounds.programs.all, rounds.options,
                                                            rounds.limits.deadline, budget / part_for_four_bars, used);
    std::vector<Trial> trials = short_searches_about(rounds, std::move(parts), left() / part_for_short_searches);
    keep_different(trials, static_cast<int>(left() / part_for_long_searches / evaluations_of_long_search));
    rounds.go_on(trials, evaluations_of_long_search);
    keep_first_trials(trials, static_cast<std::size_t>(left() / evaluations_of_whole_search));
    rounds.go_on(trials, evaluations_of_whole_search);
    rounds.search_nearby(0, trials, end);
    std::stable_partition(trials.begin(), trials.end(),
                          [&](const Trial& trial) { return rounds.assessed(trial).feasible; });
    keep_first_trials(trials, most_kept_about_parts);
    return trials;
}

}  // namespace mechwright
