// The kernels of the ram-driving mechanisms: each order of motion, and the measures that the optimisers ask for.

#include "analysis/quick_return.h"

#include <benchmark/benchmark.h>

#include <numbers>

#include "analysis/slider_crank.h"

namespace {

using namespace mechwright;

constexpr SliderCrank<double> slider_crank{40, 120, 25};
constexpr CrankShaper<double> crank_shaper{300, 150, 200, 150, 196.6};
constexpr Whitworth<double> whitworth{100, 150, 80, 300, 1.2};
constexpr DragLink<double> drag_link{{30, 60, 70, 80}, 60, 0.2, 200, 0.5, 5, Assembly::open};

template <class Drive, class Measure>
void over_the_turn(benchmark::State& state, const Drive& drive, const Measure& measure) {
    double angle = 0;
    for (auto _ : state) {
        angle += 2.399963229728653;  // the golden angle
        if (angle > 2 * std::numbers::pi) angle -= 2 * std::numbers::pi;
        benchmark::DoNotOptimize(measure(drive, angle));
    }
    state.SetItemsProcessed(state.iterations());
}

template <class Drive>
void kernels(const std::string& name, const Drive& drive) {
    benchmark::RegisterBenchmark((name + ": ram position").c_str(), [drive](benchmark::State& state) {
        over_the_turn(state, drive, [](const Drive& m, double x) { return ram_position(m, x); });
    });
    benchmark::RegisterBenchmark((name + ": ram velocity").c_str(), [drive](benchmark::State& state) {
        over_the_turn(state, drive, [](const Drive& m, double x) { return ram_velocity(m, x); });
    });
    benchmark::RegisterBenchmark((name + ": ram acceleration").c_str(), [drive](benchmark::State& state) {
        over_the_turn(state, drive, [](const Drive& m, double x) { return ram_acceleration(m, x); });
    });
    benchmark::RegisterBenchmark(
        (name + ": ends and extremes of speed of the working part").c_str(), [drive](benchmark::State& state) {
            for (auto _ : state) {
                const auto part = working_part(drive, 0.6);
                benchmark::DoNotOptimize(ram_velocity_extremes(drive, CrankRange<double>{false, part.from, part.to}));
            }
        });
}

const bool registered = [] {
    kernels("slider-crank", slider_crank);
    kernels("crank shaper", crank_shaper);
    kernels("Whitworth", whitworth);
    kernels("drag link", drag_link);
    return true;
}();

}  // namespace
