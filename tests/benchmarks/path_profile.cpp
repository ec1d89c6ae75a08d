// Data profiles of path problems: how many of the seeds come within a part of the best known sum of squares, with how
// many evaluations, by our search, by differential evolution and by controlled random search (NLopt's CRS2) on the same
// objective and in the same box. An evaluation is the sum of squares of one design; ours are counted whole, with those
// of every search that the run made and of every candidate that was screened, and each with derivatives as three.

#include <benchmark/benchmark.h>
#include <nlopt.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "synthesis/problem/reader.h"
#include "synthesis/program/program.h"
#include "synthesis/search/low_discrepancy.h"
#include "synthesis/search/path_search.h"

namespace {

using namespace mechwright;

constexpr int seeds = 20;
constexpr long budget = 200000;
constexpr std::array<double, 3> targets{1e-2, 1e-3, 1e-6};

Problem shipped(const std::string& name) {
    const std::string file = MECHWRIGHT_SOURCE_DIR "/problems/path/" + name;
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return parse_problem(text, file).problem;
}

/// Evaluations and seconds until each target was reached; negative: never.
struct Reached {
    std::array<double, 3> evaluations{-1, -1, -1};
    std::array<double, 3> seconds{-1, -1, -1};
};

/// The objective that all of them see, and what came of it.
struct Watched {
    const Program& program;
    double best_known;
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    long evaluations = 0;
    Reached reached{};

    double operator()(const Eigen::VectorXd& x) {
        ++evaluations;
        PathResiduals r;
        const double sum = path_residuals(program, x, false, r) ? r.value.squaredNorm() : 1e6;
        for (std::size_t k = 0; k < targets.size(); ++k)
            if (reached.evaluations[k] < 0 && sum <= best_known * (1 + targets[k])) {
                reached.evaluations[k] = static_cast<double>(evaluations);
                reached.seconds[k] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            }
        return sum;
    }
    bool done() const { return evaluations >= budget || reached.evaluations.back() >= 0; }
};

/// DE/rand/1/bin with the usual F = 0.6, crossover 0.9 and ten vectors per variable (Storn and Price 1997).
void differential_evolution(Watched& objective, std::uint64_t seed) {
    const Program& program = objective.program;
    const std::size_t n = program.size(), size = 10 * n;
    std::uint64_t state = mixed(seed);
    const auto number = [&] { return std::ldexp(static_cast<double>((state = mixed(state)) >> 11), -53); };
    const auto within = [&](std::size_t i, double u) {
        const Variable& v = program.variables[i];
        return v.lower + u * (v.upper - v.lower);
    };
    std::vector<Eigen::VectorXd> all(size, Eigen::VectorXd(static_cast<Eigen::Index>(n)));
    std::vector<double> sums(size);
    for (std::size_t k = 0; k < size; ++k) {
        for (std::size_t i = 0; i < n; ++i)
            all[k][static_cast<Eigen::Index>(i)] = within(i, number());
        sums[k] = objective(all[k]);
    }
    while (!objective.done())
        for (std::size_t k = 0; k < size && !objective.done(); ++k) {
            const auto any = [&] { return static_cast<std::size_t>(number() * static_cast<double>(size)); };
            const Eigen::VectorXd mutant = all[any()] + 0.6 * (all[any()] - all[any()]);
            Eigen::VectorXd trial = all[k];
            const auto certain = static_cast<std::size_t>(number() * static_cast<double>(n));
            for (std::size_t i = 0; i < n; ++i)
                if (number() < 0.9 || i == certain)
                    trial[static_cast<Eigen::Index>(i)] = std::clamp(
                        mutant[static_cast<Eigen::Index>(i)], program.variables[i].lower, program.variables[i].upper);
            const double sum = objective(trial);
            if (sum > sums[k]) continue;
            sums[k] = sum;
            all[k] = trial;
        }
}

double nlopt_objective(unsigned n, const double* x, double*, void* data) {
    return (*static_cast<Watched*>(data))(Eigen::Map<const Eigen::VectorXd>(x, static_cast<Eigen::Index>(n)));
}

void controlled_random_search(Watched& objective, std::uint64_t seed) {
    const Program& program = objective.program;
    const auto n = static_cast<unsigned>(program.size());
    std::vector<double> lower, upper, x;
    for (const Variable& v : program.variables) {
        lower.push_back(v.lower);
        upper.push_back(v.upper);
        x.push_back(0.5 * (v.lower + v.upper));
    }
    nlopt_srand(seed);
    nlopt_opt search = nlopt_create(NLOPT_GN_CRS2_LM, n);
    nlopt_set_min_objective(search, nlopt_objective, &objective);
    nlopt_set_lower_bounds(search, lower.data());
    nlopt_set_upper_bounds(search, upper.data());
    nlopt_set_maxeval(search, static_cast<int>(budget));
    double least = 0;
    nlopt_optimize(search, x.data(), &least);
    nlopt_destroy(search);
}

/// The whole search; what it did before it came across the best is not told apart from what it did after.
void ours(const Problem& problem, Watched& objective, std::uint64_t seed) {
    Problem seeded = problem;
    seeded.solver.seed = seed;
    const Multistart m = path_search(seeded, {}, std::chrono::steady_clock::time_point::max());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - objective.begin).count();
    const double length = objective.program.length;
    for (std::size_t k = 0; k < targets.size(); ++k) {
        if (m.optima.empty() ||
            m.optima.front().objective / (length * length) > objective.best_known * (1 + targets[k]))
            continue;
        objective.reached.evaluations[k] = static_cast<double>(3 * m.report.evaluations + m.report.screened);
        objective.reached.seconds[k] = seconds;
    }
}

enum class Search { ours, differential_evolution, controlled_random };

void profile(benchmark::State& state, const char* file, double best_known, Search search) {
    const Problem problem = shipped(file);
    const Program program = build_program(problem, variants(problem).front());
    std::vector<Reached> all;
    for (auto _ : state)
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            Watched objective{program, best_known / (program.length * program.length)};
            if (search == Search::ours) ours(problem, objective, seed);
            if (search == Search::differential_evolution) differential_evolution(objective, seed);
            if (search == Search::controlled_random) controlled_random_search(objective, seed);
            all.push_back(objective.reached);
        }
    const std::array<std::string, 3> names{"1%", "1e-3", "1e-6"};
    for (std::size_t k = 0; k < targets.size(); ++k) {
        std::vector<double> evaluations, seconds;
        for (const Reached& r : all)
            if (r.evaluations[k] >= 0) {
                evaluations.push_back(r.evaluations[k]);
                seconds.push_back(r.seconds[k]);
            }
        state.counters[names[k] + " seeds %"] = 100.0 * static_cast<double>(evaluations.size()) / seeds;
        if (evaluations.empty()) continue;
        std::sort(evaluations.begin(), evaluations.end());
        std::sort(seconds.begin(), seconds.end());
        state.counters[names[k] + " evals"] = evaluations[evaluations.size() / 2];
        state.counters[names[k] + " ms"] = 1e3 * seconds[seconds.size() / 2];
    }
}
BENCHMARK_CAPTURE(profile, case_2_ours, "case-2.toml", 7.415751307e-7, Search::ours)
    ->Name("campaign: case 2, least-squares")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(profile, case_2_de, "case-2.toml", 7.415751307e-7, Search::differential_evolution)
    ->Name("campaign: case 2, differential evolution")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(profile, case_2_crs, "case-2.toml", 7.415751307e-7, Search::controlled_random)
    ->Name("campaign: case 2, CRS2")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(profile, case_3_ours, "case-3.toml", 0.009028884631, Search::ours)
    ->Name("campaign: case 3, least-squares")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(profile, case_3_de, "case-3.toml", 0.009028884631, Search::differential_evolution)
    ->Name("campaign: case 3, differential evolution")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(profile, case_3_crs, "case-3.toml", 0.009028884631, Search::controlled_random)
    ->Name("campaign: case 3, CRS2")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
