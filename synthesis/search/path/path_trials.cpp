#include "synthesis/search/path/path_trials.h"

#include <algorithm>

namespace mechwright {

namespace {

/// Of searches whose sums agree to this part no more than so many are kept.
constexpr double same_basin_within = 1e-2;
constexpr int most_alike = 4;
constexpr std::size_t most_elites = 4;

}  // namespace

void sort_by_sum(std::vector<Trial>& trials) {
    std::stable_sort(trials.begin(), trials.end(),
                     [](const Trial& a, const Trial& b) { return a.outcome.objective < b.outcome.objective; });
}

void keep_different(std::vector<Trial>& trials, int most) {
    std::vector<Trial> kept;
    int alike = 0;
    for (Trial& trial : trials) {
        if (static_cast<int>(kept.size()) >= most) break;
        const bool same =
            !kept.empty() && trial.outcome.objective <= (1 + same_basin_within) * kept.back().outcome.objective;
        alike = same ? alike + 1 : 1;
        if (alike <= most_alike) kept.push_back(std::move(trial));
    }
    trials = std::move(kept);
}

std::vector<Trial> elites_of(const std::vector<Trial>& sorted) {
    std::vector<Trial> elites;
    for (const Trial& trial : sorted) {
        if (elites.size() >= most_elites) break;
        if (elites.empty() || trial.outcome.objective > (1 + same_basin_within) * elites.back().outcome.objective)
            elites.push_back(trial);
    }
    return elites;
}

}  // namespace mechwright
