#include "synthesis/bench/profiles/searches.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/local/controlled_random_search.h"
#include "synthesis/program/assess.h"
#include "synthesis/search/multistart.h"
#include "synthesis/search/path/path_search.h"

namespace mechwright::bench {

namespace {

using Eigen::VectorXd;

/// More than any design is worth.
constexpr double not_assembled = 1e6;
constexpr double per_violation = 10;

double fraction(std::uint64_t& state) {
    return std::ldexp(static_cast<double>((state = mixed(state)) >> 11) + 0.5, -53);
}

/// The objective as a search without derivatives sees it, and what came of it.
struct Watched {
    const Arena& arena;
    long values = 0;
    double best = unlimited;
    std::vector<Mark> marks{};

    double operator()(const VectorXd& x) {
        ++values;
        const double merit = arena.merit(x);
        if (merit < best) {
            best = merit;
            marks.push_back({merit, {values, 0, 0}});
        }
        return merit;
    }
    bool done() const { return values >= arena.budget; }
};

/// DE/rand/1/bin with the usual F = 0.6, crossover 0.9 and ten vectors per variable (Storn and Price 1997).
std::vector<Mark> differential_evolution(const Arena& arena, std::uint64_t seed) {
    const Program& program = arena.known.program;
    const auto n = static_cast<Eigen::Index>(program.size());
    const auto size = static_cast<std::size_t>(10 * n);
    std::uint64_t state = mixed(seed);
    Watched watched{arena};
    std::vector<VectorXd> all;
    std::vector<double> merits;
    for (std::size_t k = 0; k < size; ++k) {
        all.push_back(random_point(program, state));
        merits.push_back(watched(all.back()));
    }
    const auto any = [&] { return static_cast<std::size_t>(fraction(state) * static_cast<double>(size)); };
    while (!watched.done())
        for (std::size_t k = 0; k < size && !watched.done(); ++k) {
            const VectorXd mutant = within_bounds(program, all[any()] + 0.6 * (all[any()] - all[any()]));
            VectorXd trial = all[k];
            const auto certain = static_cast<Eigen::Index>(fraction(state) * static_cast<double>(n));
            for (Eigen::Index i = 0; i < n; ++i)
                if (fraction(state) < 0.9 || i == certain) trial[i] = mutant[i];
            const double merit = watched(trial);
            if (merit > merits[k]) continue;
            merits[k] = merit;
            all[k] = trial;
        }
    return watched.marks;
}

/// NLopt's CRS2 with local mutation, its own defaults.
std::vector<Mark> by_controlled_random_search(const Arena& arena, std::uint64_t seed) {
    const Program& program = arena.known.program;
    std::uint64_t state = mixed(seed);
    const VectorXd start = random_point(program, state);
    Watched watched{arena};
    BoxFunction box{[&](const std::vector<double>& x) {
                        return watched(Eigen::Map<const VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())));
                    },
                    {},
                    {}};
    for (const Variable& v : program.variables) {
        // A variable that follows from the others has no range; it is set before the objective is asked for.
        box.lower.push_back(std::isfinite(v.lower) ? v.lower : 0);
        box.upper.push_back(std::isfinite(v.upper) ? v.upper : 1);
    }
    controlled_random_search(box, {start.begin(), start.end()}, static_cast<int>(arena.budget), seed);
    return watched.marks;
}

std::vector<Mark> marks_of(const Arena& arena, const Multistart& found) {
    std::vector<Mark> marks;
    for (const Milestone& m : found.milestones)
        if (m.best) marks.push_back({arena.merit(*m.best), {m.screened, m.evaluations, m.hessians}});
    return marks;
}

Problem seeded(const Problem& problem, std::uint64_t seed) {
    Problem copy = problem;
    copy.solver.seed = seed;
    return copy;
}

std::vector<Mark> multistart_slsqp(const Arena& arena, std::uint64_t seed) {
    const Problem problem = seeded(*arena.problem, seed);
    return marks_of(arena, multistart(problem, slsqp, {}, std::chrono::steady_clock::time_point::max()));
}

std::vector<Mark> screened_least_squares(const Arena& arena, std::uint64_t seed) {
    const Problem problem = seeded(*arena.problem, seed);
    return marks_of(arena, path_search(problem, {}, std::chrono::steady_clock::time_point::max()));
}

bool always(const Problem&) { return true; }

}  // namespace

double Arena::merit(VectorXd x) const {
    settle_epigraphs(known.program, x);
    ProgramValues values;
    evaluate(known.program, x, false, values);
    if (!values.assembled || !std::isfinite(values.objective)) return not_assembled;
    return values.objective + per_violation * violation(known.program, x, values);
}

double Arena::merit(const Solution& solution) const {
    if (!std::isfinite(solution.violation) || !std::isfinite(solution.objective)) return not_assembled;
    return user_units * solution.objective + (solution.feasible ? 0 : per_violation * solution.violation);
}

std::optional<Arena> arena_of(const Problem& problem, long budget, const RunOptions& options) {
    auto known = known_optimum(problem, options);
    if (!known) return std::nullopt;
    const double in_file = assess(problem, design_at(known->program, known->x)).objective;
    const double units = known->objective / in_file;
    return Arena{&problem, *std::move(known), units, budget};
}

VectorXd random_point(const Program& program, std::uint64_t& state) {
    VectorXd x(static_cast<Eigen::Index>(program.size()));
    for (std::size_t i = 0; i < program.size(); ++i) {
        const Variable& v = program.variables[i];
        const double part = fraction(state);
        x[static_cast<Eigen::Index>(i)] =
            std::isfinite(v.lower) && std::isfinite(v.upper) ? v.lower + part * (v.upper - v.lower) : 0;
    }
    return x;
}

std::vector<GlobalSearch> global_searches() {
    return {{"screening and least squares", [](const Problem& p) { return why_no_path_search(p).empty(); },
             screened_least_squares},
            {"multistart SLSQP", always, multistart_slsqp},
            {"differential evolution", always, differential_evolution},
            {"CRS2", always, by_controlled_random_search}};
}

}  // namespace mechwright::bench
