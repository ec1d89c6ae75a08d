// Coupler points of many four-bars: one by one through the template for double, and in lanes by every instruction set
// that the processor has. Points per second on one core; the digits are the same.

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

#include "analysis/four_bar.h"
#include "synthesis/mechanism/four_bar/screening.h"
#include "synthesis/search/low_discrepancy.h"

namespace {

using namespace mechwright;

constexpr std::size_t groups = 512;

const std::vector<FourBarGroup>& linkages() {
    static const std::vector<FourBarGroup> all = [] {
        std::vector<FourBarGroup> made(groups);
        const LowDiscrepancy sequence(6, 1, 1);
        std::uint64_t k = 0;
        for (FourBarGroup& g : made)
            for (std::size_t lane = 0; lane < 8; ++lane, ++k) {
                // Crank-rockers: the shortest link and three margins.
                const double crank = 0.2 + sequence(k, 0), p = sequence(k, 1), q = sequence(k, 2), s = sequence(k, 3);
                const std::array<double, 4> links{crank + (q + s) / 2, crank, crank + (p + s) / 2, crank + (p + q) / 2};
                for (std::size_t i = 0; i < 4; ++i)
                    g.links[i][lane] = links[i];
                g.along[lane] = sequence(k, 4);
                g.across[lane] = sequence(k, 5);
            }
        return made;
    }();
    return all;
}

void one_by_one(benchmark::State& state) {
    std::vector<PointGroup> points(groups);
    double angle = 0;
    for (auto _ : state) {
        const HalfTurn<double> half = half_turn(angle += 0.1);
        for (std::size_t g = 0; g < groups; ++g)
            for (std::size_t lane = 0; lane < 8; ++lane) {
                const auto& m = linkages()[g];
                const FourBar<double> links{m.links[0][lane], m.links[1][lane], m.links[2][lane], m.links[3][lane]};
                const auto p = position(links, CouplerPoint<double>{m.along[lane], m.across[lane]},
                                        pose(links, half, Assembly::open));
                points[g].x[lane] = p.x;
                points[g].y[lane] = p.y;
            }
        benchmark::DoNotOptimize(points.data());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(8 * groups));
}
BENCHMARK(one_by_one)->Name("coupler points: one by one");

void in_lanes(benchmark::State& state, InstructionSet set) {
    if (!is_available(set)) return state.SkipWithError("not on this processor");
    std::vector<PointGroup> points(groups);
    double angle = 0;
    for (auto _ : state) {
        coupler_points(set, Assembly::open, linkages(), half_turn(angle += 0.1), points);
        benchmark::DoNotOptimize(points.data());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(8 * groups));
}
BENCHMARK_CAPTURE(in_lanes, baseline, InstructionSet::baseline)->Name("coupler points: lanes, baseline x86-64");
BENCHMARK_CAPTURE(in_lanes, avx2, InstructionSet::avx2)->Name("coupler points: lanes, AVX2");
BENCHMARK_CAPTURE(in_lanes, avx512, InstructionSet::avx512)->Name("coupler points: lanes, AVX-512");

/// A candidate of eighteen timed points with placement, size and coupler point eliminated.
void screening(benchmark::State& state, InstructionSet set) {
    if (!is_available(set)) return state.SkipWithError("not on this processor");
    std::vector<ScreenedPoint> points;
    for (int i = 0; i < 18; ++i) {
        const auto half = half_turn(0.35 * i);
        points.push_back({{std::cos(0.35 * i), std::sin(0.5 * i)}, 1, {half.cosine, half.sine}});
    }
    for (auto _ : state)
        for (const FourBarGroup& g : linkages())
            benchmark::DoNotOptimize(four_bar_screening(set, 0, g.links, points, {true, true, true}));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(8 * groups));
}
BENCHMARK_CAPTURE(screening, baseline, InstructionSet::baseline)->Name("candidates of 18 points: baseline x86-64");
BENCHMARK_CAPTURE(screening, avx2, InstructionSet::avx2)->Name("candidates of 18 points: AVX2");
BENCHMARK_CAPTURE(screening, avx512, InstructionSet::avx512)->Name("candidates of 18 points: AVX-512");

}  // namespace
