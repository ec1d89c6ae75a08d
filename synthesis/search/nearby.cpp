#include "synthesis/search/nearby.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/variant.h"
#include "synthesis/search/polished_search.h"

namespace mechwright {

namespace {

/// A gradient unbalanced by more is that of no optimum, and starts close to the design may lead on.
constexpr double far_off_from = 1e-3;

/// Starts of a round, as parts of every variable away from the design.
constexpr std::array<double, 4> away{0, 1e-3, 1e-4, 1e-2};
constexpr int most_rounds = 24;  ///< in flat valleys each gains a little
/// A round that gains less than this part, or less than that of what the program was scaled for, is the last.
constexpr double goes_on_from = 1e-9;
constexpr double least_gain = 1e-12;

Eigen::VectorXd start_near(const Program& program, Eigen::VectorXd x, double part, std::uint64_t seed) {
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        seed = mixed(seed);
        const double way = std::ldexp(static_cast<double>(seed >> 11), -52) - 1;  // from -1 to 1
        x[i] += way * part * (std::abs(x[i]) + part);
    }
    x = within_bounds(program, std::move(x));
    settle_epigraphs(program, x);
    return x;
}

/// One round from a point: the best that either method comes to.
LocalOutcome round_from(const Program& program, const LocalOutcome& from, int round, const LocalLimits& limits) {
    LocalOutcome best = from;
    const bool far_off = unbalanced_part(program, from.x) > far_off_from;
    for (std::size_t k = 0; k < (far_off ? away.size() : 1); ++k)
        for (const LocalMethod method : {ipopt, slsqp}) {
            if (limits.reached()) return best;
            const auto seed = static_cast<std::uint64_t>(round) * away.size() + k;
            const LocalOutcome outcome =
                polished_search(program, start_near(program, best.x, away[k], seed), method, limits);
            best.evaluations += outcome.evaluations;
            if (outcome.violation > LocalOutcome::feasible_below || !(outcome.objective < best.objective)) continue;
            best.x = outcome.x;
            best.objective = outcome.objective;
            best.violation = outcome.violation;
        }
    return best;
}

}  // namespace

NearbyOptimum nearby(const Problem& problem, const Design& from, const LocalLimits& limits) {
    NearbyOptimum best;
    for (const Variant& variant : variants(problem)) {
        if (variant.assembly != from.assembly || limits.reached()) continue;
        const Program program = build_program(problem, variant);
        const LocalOutcome outcome = polished_search(program, point_of(program, from), slsqp, limits);
        best.evaluations += outcome.evaluations;
        if (outcome.x.size() == 0) continue;
        Solution found = assess(problem, design_at(program, outcome.x));
        if (!found.feasible || (best.solution && !preferred(problem, found, *best.solution))) continue;
        best.solution = std::move(found);
        best.stationary = !problem.objective || unbalanced_part(program, outcome.x) < balanced_within;
    }
    return best;
}

NearbyOptimum settled(const Problem& problem, const Design& from, long enough, const LocalLimits& limits) {
    NearbyOptimum best;
    LocalLimits near = limits;
    near.near_optimum = true;
    for (const Variant& variant : variants(problem)) {
        if (variant.assembly != from.assembly) continue;
        const Program program = build_program(problem, variant);
        const Eigen::VectorXd x = point_of(program, from);
        ProgramValues values;
        evaluate(program, x, false, values);
        LocalOutcome here;
        here.consider(program, x, values);
        if (here.violation > LocalOutcome::feasible_below) continue;
        double before = unlimited;
        bool balanced = unbalanced_part(program, here.x) <= balanced_within;
        for (int round = 0; round < most_rounds && !balanced; ++round) {
            const double gain = std::max(goes_on_from * std::abs(here.objective), least_gain);
            if (!(here.objective < before - gain) || (round > 0 && here.evaluations > enough)) break;
            before = here.objective;
            here = round_from(program, here, round, near);
            balanced = unbalanced_part(program, here.x) <= balanced_within;
        }
        best.evaluations += here.evaluations;
        Solution found = assess(problem, design_at(program, here.x));
        if (!found.feasible || (best.solution && !preferred(problem, found, *best.solution))) continue;
        best.solution = std::move(found);
        best.stationary = balanced;
    }
    return best;
}

}  // namespace mechwright
