// The kernels of the four-bar: what each order of motion costs, and what is saved by not asking for it.

#include "analysis/four_bar.h"

#include <benchmark/benchmark.h>

#include <numbers>

namespace {

using namespace mechwright;

constexpr FourBar<double> linkage{100, 25, 90, 75};
constexpr CouplerPoint<double> midpoint{45, 0};

/// Crank angles that do not let the compiler or the branch predictor know what comes.
struct Turning {
    double angle = 0;
    double next() {
        angle += 2.399963229728653;  // the golden angle
        if (angle > 2 * std::numbers::pi) angle -= 2 * std::numbers::pi;
        return angle;
    }
};

void poses(benchmark::State& state) {
    Turning crank;
    for (auto _ : state)
        benchmark::DoNotOptimize(pose(linkage, crank.next(), Assembly::open));
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(poses)->Name("four-bar: pose");

void coupler_points(benchmark::State& state) {
    Turning crank;
    for (auto _ : state)
        benchmark::DoNotOptimize(position(linkage, midpoint, pose(linkage, crank.next(), Assembly::open)));
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(coupler_points)->Name("four-bar: coupler point");

void velocities(benchmark::State& state) {
    Turning crank;
    for (auto _ : state) {
        const auto p = pose(linkage, crank.next(), Assembly::open);
        benchmark::DoNotOptimize(velocity(linkage, p));
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(velocities)->Name("four-bar: pose and velocities");

void accelerations(benchmark::State& state) {
    Turning crank;
    for (auto _ : state) {
        const auto p = pose(linkage, crank.next(), Assembly::open);
        benchmark::DoNotOptimize(acceleration(linkage, p, velocity(linkage, p)));
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(accelerations)->Name("four-bar: pose, velocities, accelerations");

void velocity_ratio_search(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(velocity_ratio_extremes(linkage, Assembly::open, {true, 0, 2 * std::numbers::pi}));
}
BENCHMARK(velocity_ratio_search)->Name("four-bar: extremes of the velocity ratio over a turn");

}  // namespace
