// Exact synthesis: dyads through five poses, certificates, and the paths of the nine-point problem against the
// tolerance of a step.

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

#include "synthesis/exact/dyads.h"
#include "synthesis/exact/homotopy/certify.h"
#include "synthesis/exact/homotopy/guidance_solutions.h"
#include "synthesis/search/low_discrepancy.h"

namespace {

using namespace mechwright;
using namespace mechwright::homotopy;

double drawn(std::uint64_t k, std::uint64_t i) {
    return std::ldexp(static_cast<double>(mixed(mixed(k) ^ i) >> 11) + 0.5, -53) - 0.5;
}

std::array<Displacement, 4> random_poses(std::uint64_t k) {
    std::array<Displacement, 4> poses;
    for (std::uint64_t i = 0; i < 4; ++i)
        poses[i] = {{3 * drawn(k, 3 * i), 3 * drawn(k, 3 * i + 1)}, std::polar(1.0, 6 * drawn(k, 3 * i + 2))};
    return poses;
}

/// Four dyads over the complex numbers each.
void dyads_of_five_poses(benchmark::State& state) {
    std::uint64_t k = 0;
    std::size_t dyads = 0;
    for (auto _ : state)
        dyads += dyads_through(random_poses(k++ % 1000)).dyads.size();
    state.counters["dyads_each"] = benchmark::Counter(static_cast<double>(dyads), benchmark::Counter::kAvgIterations);
}
BENCHMARK(dyads_of_five_poses)->Unit(benchmark::kMicrosecond);

/// Problem 3 of Wampler, Morgan and Sommese.
const std::vector<Place> problem_3{{{0.25, 0}, {}},    {{0.52, 0.10}, {}}, {{0.80, 0.70}, {}},
                                   {{1.20, 1.00}, {}}, {{1.40, 1.30}, {}}, {{1.10, 1.48}, {}},
                                   {{0.70, 1.40}, {}}, {{0.20, 1.00}, {}}, {{0.02, 0.40}, {}}};

/// Its 1442 paths alone, on one core: the predictor's error is 10^-argument, relative. Ends that agree are paths that
/// have jumped to others.
void paths_against_tolerance(benchmark::State& state) {
    const GuidanceTarget target = guidance_target(problem_3);
    const StartSystem& start = start_system(target.system);
    TrackingOptions options;
    options.prediction_error = std::pow(10.0, -static_cast<double>(state.range(0)));
    options.correction_error = 0.1 * options.prediction_error;
    double steps = 0, distinct = 0;
    for (auto _ : state) {
        const auto paths = track(target.system, start.solutions, start.parameters, target.parameters, options, 1);
        steps = distinct = 0;
        SeenOrbits seen;
        for (std::size_t i = 0; i < paths.size(); ++i) {
            steps += paths[i].steps;
            GuidanceValues end = paths[i].point;
            if (paths[i].end != PathEnd::reached || refine(target.system, end, target.parameters) > 1e-11) continue;
            distinct += !seen.find_or_keep(orbit_of(target.system, end), i);
        }
    }
    state.counters["paths_per_second"] =
        benchmark::Counter(1442.0 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    state.counters["steps_each"] = steps / 1442;
    state.counters["distinct"] = distinct;
}
BENCHMARK(paths_against_tolerance)->DenseRange(3, 8)->Unit(benchmark::kMillisecond);

/// The whole of it on one core: with all that makes every path accounted for.
void nine_points_solved(benchmark::State& state) {
    const GuidanceTarget target = guidance_target(problem_3);
    const StartSystem& start = start_system(target.system);
    for (auto _ : state)
        benchmark::DoNotOptimize(solve_guidance(start, target.parameters, 1));
}
BENCHMARK(nine_points_solved)->Unit(benchmark::kMillisecond);

/// The proof that one of its real solutions exists, in fifty digits.
void certificate_of_nine_points(benchmark::State& state) {
    const GuidanceTarget target = guidance_target(problem_3);
    const auto found = solve_guidance(start_system(target.system), target.parameters, 1);
    const auto exact = exact_parameters(target, problem_3);
    for (auto _ : state)
        benchmark::DoNotOptimize(certify(target.system, found.solutions.front(), exact));
}
BENCHMARK(certificate_of_nine_points)->Unit(benchmark::kMicrosecond);

}  // namespace
