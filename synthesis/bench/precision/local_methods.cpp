#include "synthesis/bench/precision/local_methods.h"

#include "synthesis/search/path/path_objective.h"
#include "synthesis/search/polished_search.h"
#include "synthesis/search/starts.h"

namespace mechwright::bench {

namespace {

bool always(const Problem&) { return true; }

bool one_worst_counts(const Problem& problem) {
    return asks_for_one_worst(build_program(problem, variants(problem).front()));
}

LocalOutcome polished_slsqp(const Program& program, const Eigen::VectorXd& start, const LocalLimits& limits) {
    return polished_search(program, start, slsqp, limits);
}

LocalOutcome polished_ipopt(const Program& program, const Eigen::VectorXd& start, const LocalLimits& limits) {
    return polished_search(program, start, ipopt, limits);
}

}  // namespace

std::vector<LocalCandidate> local_candidates() {
    return {{"SLSQP", always, slsqp},
            {"SLSQP, polished", always, polished_slsqp},
            {"Ipopt", always, ipopt},
            {"Ipopt, polished", always, polished_ipopt},
            {"Madsen's method", one_worst_counts, minimax},
            {"Levenberg-Marquardt", least_squares_suffice, levenberg_marquardt}};
}

std::vector<Start> first_starts(const Problem& problem, const std::vector<Program>& programs, int count) {
    const auto variants_count = static_cast<int>(programs.size());
    std::vector<Start> starts;
    for (int k = 0; k < count; ++k) {
        const Program& program = programs[static_cast<std::size_t>(k % variants_count)];
        starts.push_back(
            {&program, start_point(program, problem.solver.seed, k / variants_count, start_candidates(problem))});
    }
    return starts;
}

}  // namespace mechwright::bench
