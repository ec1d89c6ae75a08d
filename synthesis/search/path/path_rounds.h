#pragma once
/// \file
/// The rounds of the search for a path: each screens starts, goes a few steps by least squares from the best of them,
/// runs the most promising to their end, and goes on from these to others nearby.

#include <chrono>
#include <cstddef>
#include <limits>
#include <vector>

#include "synthesis/program/result.h"
#include "synthesis/program/run_options.h"
#include "synthesis/search/path/path_programs.h"
#include "synthesis/search/path/path_trials.h"
#include "synthesis/search/screened_starts.h"

namespace mechwright {

/// A round has as many starts as the problem asks for, but no more than this.
inline constexpr int most_starts_of_round = 32;
/// Searches take a little way, farther, and to their end.
inline constexpr int evaluations_of_short_search = 25;
inline constexpr int evaluations_of_long_search = 100;
inline constexpr int evaluations_of_whole_search = 600;
/// Sums of squares that agree to this part are taken for the same optimum before it is looked at closely.
inline constexpr double same_sum_within = 1e-3;

/// What rounds go by, and how far they have come.
struct PathRounds {
    const Problem& problem;
    const RunOptions& options;
    PathPrograms programs;
    std::vector<ScreenedStarts> starts;  ///< by program
    std::vector<std::size_t> searched;   ///< of the programs, those in which starts are screened
    LocalLimits limits;
    bool least_squares;  ///< the sum of squares is all that counts
    bool led;            ///< least squares lead to the objective
    int starts_of_round;
    SearchReport report{};     ///< what has been drawn and evaluated
    bool met_exactly = false;  ///< a short search came to all points exactly

    /// Those of a problem, which must outlive them, as the options must.
    PathRounds(const Problem& p, const RunOptions& o, std::chrono::steady_clock::time_point deadline);

    /// The searches of a round, best first, each as far as it was worth it.
    std::vector<Trial> trials_of(int round);

    /// Whether a round can end at the first search that comes to all points exactly.
    bool may_end_early() const { return least_squares && programs.skip_margins(); }

    Solution assessed(const Trial& trial) const;

    /// The cognates of a design as they are, none searched from; none where its mechanism has none.
    std::vector<Solution> cognates_of_design(const Design& design) const;

    // Steps of a round by themselves.

    /// A search of a program from a start, for no more than so many evaluations.
    Trial short_trial(std::size_t program, const Eigen::VectorXd& start, TrialStart from, int evaluations) const;
    /// The best starts of every variant, each taken a little way; best first.
    std::vector<Trial> short_searches(int round);
    /// All of them taken farther, each for no more than so many evaluations; best first.
    void go_on(std::vector<Trial>& trials, int evaluations);
    /// Goes on from the best of a round to starts nearby, and from what is better there, as long as there were fewer
    /// than so many evaluations; adds what it comes to.
    void search_nearby(int round, std::vector<Trial>& trials, long until = std::numeric_limits<long>::max());

private:
    std::vector<Eigen::VectorXd> screened(std::size_t program, int number, int keep, DrawCounts& counts) const;
    void keep_best_assemblies(std::vector<Trial>& trials);
    bool ends_at_zero(std::vector<Trial>& wave) const;
    bool best_meets_all(const std::vector<Trial>& sorted) const;
    void run_to_end(std::vector<Trial>& trials);
};

}  // namespace mechwright
