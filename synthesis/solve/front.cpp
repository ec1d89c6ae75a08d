#include "synthesis/solve/front.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "synthesis/local/local.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/search/nearby.h"
#include "synthesis/solve/choose.h"
#include "synthesis/solve/parts.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

using Clock = std::chrono::steady_clock;

/// The limit at the far end lies this part of the whole span inside, where designs are still free to move.
constexpr double inside = 1e-6;

/// A measure of an error: of a path, a function or a line.
bool is_error(const Problem& problem, const ObjectiveTerm& term) {
    return !problem.mechanism->quantities[term.quantity].section.empty();
}

struct Front {
    const Problem& problem;
    const RunOptions& options;
    Clock::time_point deadline;
    double own_best;          ///< of the problem's own objective, for whoever watches
    ObjectiveTerm optimised;  ///< under limits on the other
    ObjectiveTerm limited;
    int done = 0;

    Front(const Problem& p, const RunOptions& o, Clock::time_point d, double b)
        : problem(p),
          options(o),
          deadline(d),
          own_best(b),
          optimised(p.objective->terms[0]),
          limited(p.objective->terms[1]) {
        // Limits on an error are the harder ones: many designs miss them at first.
        if (!is_error(p, optimised) && is_error(p, limited)) std::swap(optimised, limited);
    }

    int points() const { return problem.solver.pareto; }
    int searches() const {
        return points() + 1 + (is_error(problem, optimised) ? 0 : 1) + (is_error(problem, limited) ? 0 : 1);
    }
    bool stopped() const { return (options.stop && options.stop->load()) || Clock::now() >= deadline; }

    /// The term's value, its sign turned so that less is better.
    double cost(const ObjectiveTerm& term, const Design& design) const {
        const auto value = quantity_value(problem, term.quantity, design);
        if (!value) return unlimited;
        return term.maximize ? -*value : *value;
    }

    /// The problem of one objective, the other one limited where a limit is given.
    Problem part(const ObjectiveTerm& term, std::optional<double> limit) const {
        Problem sub = problem;
        sub.text.clear();  // which asks for something else
        sub.solver.pareto = 0;
        sub.objective = Objective{};
        sub.objective->terms.push_back({term.quantity, term.maximize, 1});
        if (limit) require(sub, limited, *limit, false);
        return sub;
    }

    std::optional<Design> searched(Problem sub) {
        if (stopped()) return std::nullopt;
        sub.solver.time_limit = std::chrono::duration<double>(deadline - Clock::now()).count();
        const Result result = solve(sub, quiet(options));
        ++done;
        if (options.progress) options.progress(done, searches(), own_best);
        if (!result.best || !result.best->feasible) return std::nullopt;
        return result.best->design;
    }

    /// Adds to a problem that a term has the value of a cost exactly, or at least to the problem's tolerance.
    static void require(Problem& sub, const ObjectiveTerm& term, double cost, bool exactly) {
        const double value = term.maximize ? -cost : cost;
        Requirement r;
        r.quantity = term.quantity;
        if (exactly)
            r.equal = value;
        else
            (term.maximize ? r.min : r.max) = value;
        sub.requirements.push_back(r);
    }

    /// An end of the front: of all designs that are as good in one objective as a design that was found the best in the
    /// other. Where the one is held at a limit of the problem there is a choice.
    Design settled_end(const ObjectiveTerm& best, const ObjectiveTerm& other, const Design& found) {
        const double least = cost(best, found);
        const double reached = least + problem.solver.tolerance * std::abs(least);
        Design end = found;
        const auto consider = [&](const std::optional<Design>& candidate) {
            if (candidate && cost(best, *candidate) <= reached && cost(other, *candidate) < cost(other, end))
                end = *candidate;
        };
        if (!is_error(problem, best)) {
            Problem exact = part(other, std::nullopt);
            require(exact, best, least, true);
            consider(searched(exact));
        }
        if (stopped()) return end;
        Problem near = part(other, std::nullopt);
        require(near, best, least, false);
        LocalLimits limits;
        limits.deadline = deadline;
        limits.stop = options.stop;
        if (const auto local = nearby(near, end, limits).solution) consider(local->design);
        return end;
    }

    struct Limited {
        double limit;
        std::optional<Design> design;
    };

    /// Takes over what a neighbour or a local search from it does better.
    void improve(Limited& at, const std::optional<Design>& neighbour) const {
        if (!neighbour || stopped()) return;
        const auto consider = [&](const Design& candidate) {
            if (cost(limited, candidate) > at.limit + std::abs(at.limit) * problem.solver.tolerance) return;
            if (!at.design || cost(optimised, candidate) < cost(optimised, *at.design)) at.design = candidate;
        };
        consider(*neighbour);
        LocalLimits limits;
        limits.deadline = deadline;
        limits.stop = options.stop;
        const auto found = nearby(part(optimised, at.limit), *neighbour, limits).solution;
        if (found) consider(found->design);
    }

    std::vector<Design> designs() {
        std::vector<Limited> all;
        auto first = searched(part(optimised, std::nullopt));
        auto last = searched(part(limited, std::nullopt));
        if (!first || !last) return {};
        first = settled_end(optimised, limited, *first);
        last = settled_end(limited, optimised, *last);
        const double from = cost(limited, *first), to = cost(limited, *last);
        if (!(from > to)) return {*first};
        all.push_back({from, first});
        for (int k = 1; k < points(); ++k) {
            const double share = k + 1 < points() ? static_cast<double>(k) / (points() - 1) : 1 - inside;
            all.push_back({from + (to - from) * share, std::nullopt});
            all.back().design = searched(part(optimised, all.back().limit));
        }
        improve(all.back(), last);
        for (std::size_t i = 1; i < all.size(); ++i)
            improve(all[i], all[i - 1].design);
        for (std::size_t i = all.size() - 1; i > 0; --i)
            improve(all[i - 1], all[i].design);
        std::vector<Design> found;
        for (Limited& at : all)
            if (at.design) found.push_back(std::move(*at.design));
        return found;
    }

    /// -1 where a is better than b in a term by more than the problem's tolerance, 1 where it is worse, else 0.
    int compared(const ObjectiveTerm& term, const Design& a, const Design& b) const {
        const double of_a = cost(term, a), of_b = cost(term, b);
        const double same = problem.solver.tolerance * std::max(std::abs(of_a), std::abs(of_b));
        return of_a < of_b - same ? -1 : of_a > of_b + same ? 1 : 0;
    }

    /// Whether a is as good as b in both objectives within the tolerance, and better in one; or, of two that are alike
    /// in both, comes first.
    bool beats(const Design& a, const Design& b, bool first) const {
        const int one = compared(optimised, a, b), other = compared(limited, a, b);
        return one <= 0 && other <= 0 && (one < 0 || other < 0 || first);
    }
};

}  // namespace

std::vector<VerifiedDesign> front(const Problem& problem, const RunOptions& options, Clock::time_point deadline,
                                  double best) {
    Front search(problem, options, deadline, best);
    std::vector<VerifiedDesign> points;
    for (const Design& design : search.designs()) {
        VerifiedDesign point{assess(problem, design), {}};
        if (!point.solution.feasible) continue;
        point.verification = checks_of(problem, point.solution);
        if (all_passed(point.verification)) points.push_back(std::move(point));
    }
    std::vector<VerifiedDesign> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Design& design = points[i].solution.design;
        bool beaten = false;
        for (std::size_t k = 0; k < points.size() && !beaten; ++k) {
            if (k != i) beaten = search.beats(points[k].solution.design, design, k < i);
        }
        if (!beaten) kept.push_back(points[i]);
    }
    const ObjectiveTerm& first = problem.objective->terms.front();
    std::stable_sort(kept.begin(), kept.end(), [&](const VerifiedDesign& a, const VerifiedDesign& b) {
        return search.cost(first, a.solution.design) < search.cost(first, b.solution.design);
    });
    return kept;
}

}  // namespace mechwright
