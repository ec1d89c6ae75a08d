#include "synthesis/exact/family_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/local/subplex.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/work_sharing.h"

namespace mechwright {

namespace {

using Numbers = std::vector<double>;

constexpr int most_improvements = 1500;  ///< evaluations of one run of a local search
constexpr int most_runs = 6;             ///< each from where the last one stopped
/// A run that gains less, relative to the objective, was the last one.
constexpr double least_gain = 1e-10;
/// Members whose dimensions differ less, relative to their size, are one.
constexpr double same_within = 1e-4;

struct Candidate {
    Numbers numbers;
    std::optional<ExactDesign> design;
};

/// Smaller is better: first the violation, then the objective.
double merit(const Problem& problem, const std::optional<ExactDesign>& design) {
    constexpr double infeasible = 1e12, worst = 1e30;
    if (!design || std::isnan(design->solution.violation)) return worst;
    const Solution& s = design->solution;
    if (!design->defect.empty()) return infeasible * (1 + std::min(std::max(s.violation, 1e-12), 1e12));
    // What is missed within the tolerance costs more than any objective gains by it: else a member would be the better
    // the more of the tolerance it uses up.
    constexpr double per_violation = 1e3;
    const double missed = per_violation * s.violation * std::abs(s.objective);
    return (maximizes(problem) ? -s.objective : s.objective) + missed;
}

struct Search {
    const Problem& problem;
    const DesignFamily& family;
    const RunEnd& end;
    std::atomic<long> evaluations{0};

    bool ended() const { return end.reached(); }

    Candidate at(Numbers numbers, const FamilyMember& member) {
        ++evaluations;
        Candidate candidate{std::move(numbers), {}};
        candidate.design = member(candidate.numbers);
        return candidate;
    }
};

/// A run of Subplex; never worse than where it began.
Candidate run_from(Search& search, const Candidate& from, const FamilyMember& member) {
    const CubeFunction function{[&](const Numbers& numbers) {
                                    ++search.evaluations;
                                    return merit(search.problem, member(numbers));
                                },
                                [&] { return search.ended(); }};
    Candidate found = search.at(subplex(function, from.numbers, most_improvements), member);
    return merit(search.problem, found.design) < merit(search.problem, from.design) ? found : from;
}

Candidate improved(Search& search, Candidate candidate) {
    for (int run = 0; run < most_runs; ++run) {
        const double before = merit(search.problem, candidate.design);
        const DesignFamily& family = search.family;
        candidate = run_from(search, candidate, family.near ? family.near(candidate.numbers) : family.member);
        const double after = merit(search.problem, candidate.design);
        if (search.ended() || before - after <= least_gain * std::abs(after)) break;
    }
    return candidate;
}

bool is_same(const Design& a, const Design& b) {
    double apart = 0, size = 0;
    for (std::size_t i = 0; i < a.dimensions.size(); ++i) {
        apart = std::max(apart, std::abs(a.dimensions[i] - b.dimensions[i]));
        size = std::max(size, std::abs(a.dimensions[i]));
    }
    return a.assembly == b.assembly && apart <= same_within * size;
}

}  // namespace

ExactDesigns search_family(const Problem& problem, const DesignFamily& family, const RunOptions& options,
                           const RunEnd& end) {
    Search search{problem, family, end};
    const LowDiscrepancy sequence(std::max<std::size_t>(family.numbers, 1), problem.solver.seed, 0);
    std::vector<Candidate> candidates(static_cast<std::size_t>(family.examined));
    constexpr int parts = 64;
    share_work(parts, options.jobs, [&](int part) {
        for (int k = part; k < family.examined && !search.ended(); k += parts) {
            Numbers drawn;
            for (std::size_t j = 0; j < family.numbers; ++j)
                drawn.push_back(sequence(static_cast<std::uint64_t>(k), j));
            candidates[static_cast<std::size_t>(k)] = search.at(std::move(drawn), family.member);
        }
    });
    std::stable_sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
        return merit(problem, a.design) < merit(problem, b.design);
    });
    candidates.resize(static_cast<std::size_t>(std::clamp(problem.solver.starts, 1, family.examined)));
    // What is not improved is kept too: an optimum may lie where a linkage cannot be relied upon any more.
    const std::vector<Candidate> as_drawn = candidates;
    if (family.numbers > 0)
        share_work(static_cast<int>(candidates.size()), options.jobs, [&](int k) {
            Candidate& candidate = candidates[static_cast<std::size_t>(k)];
            if (candidate.design && !search.ended()) candidate = improved(search, std::move(candidate));
        });
    ExactDesigns out;
    const auto add_different = [&](std::vector<Candidate> some) {
        for (Candidate& candidate : some) {
            if (!candidate.design) continue;
            const Design& design = candidate.design->solution.design;
            const bool known = std::any_of(out.designs.begin(), out.designs.end(),
                                           [&](const Solution& s) { return is_same(s.design, design); });
            if (!known) add_design(out, *std::move(candidate.design));
        }
    };
    out.starts = static_cast<int>(candidates.size());
    add_different(std::move(candidates));
    out.local_optima = static_cast<int>(out.designs.size());
    add_different(as_drawn);
    rank(problem, out);
    out.evaluations = search.evaluations;
    out.stopped = search.ended();
    out.note =
        "no member of the family that meets the targets has all that is asked for: more [solver] starts examine more";
    return out;
}

}  // namespace mechwright
