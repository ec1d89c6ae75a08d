// The smallest cam under limits on the pressure angle: sampled at so many cam angles against exact, in error and time.
// "error" is that of the prime radius; a negative one is a cam that breaks its limits between the samples.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/cam/roller_follower.h"
#include "analysis/cam/segment.h"
#include "synthesis/exact/closed_form.h"
#include "synthesis/problem/reader.h"

namespace {

using namespace mechwright;
using namespace mechwright::cam;

constexpr const char* text = R"(schema = 1
mechanism = "cam"
[cam]
follower = "knife"
[[segment]]
kind = "rise"
angle = 90
lift = 20
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 90
[[segment]]
kind = "return"
angle = 90
lift = 20
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 90
[dimensions]
prime-radius = { min = 5, max = 200 }
offset = { min = -50, max = 50 }
[[require]]
quantity = "pressure-angle-rise"
max = 30
[[require]]
quantity = "pressure-angle-return"
max = 45
[objective]
minimize = "prime-radius"
)";

double exact_size() {
    const double t = 4 * std::sqrt(3.0), u = 4;  // 2 pi cot(limit) / (pi / 2)
    const double p = 20 / std::numbers::pi * (t - std::atan(t)), q = 20 / std::numbers::pi * (u - std::atan(u));
    const double offset = (p - q) / (std::sqrt(3.0) + 1);
    return std::hypot(offset, p - std::sqrt(3.0) * offset);
}

void sampled(benchmark::State& state) {
    const auto samples = static_cast<int>(state.range(0));
    const Segment<double> rise{
        SegmentKind::rise, {SegmentLaw::Form::law, Law::cycloidal, false}, std::numbers::pi / 2, 20};
    const Segment<double> fall{
        SegmentKind::fall, {SegmentLaw::Form::law, Law::cycloidal, false}, std::numbers::pi / 2, 20};
    double size = 0;
    for (auto _ : state) {
        double p = 0, q = 0;
        for (int i = 0; i <= samples / 4; ++i) {  // a quarter of the turn each
            const double u = 4.0 * i / samples;
            const auto up = lift_at(rise, 0, u, 0.0), down = lift_at(fall, 0, u, 20.0);
            p = std::max(p, up.v * std::sqrt(3.0) - up.s);
            q = std::max(q, -down.v - down.s);
        }
        const double offset = (p - q) / (std::sqrt(3.0) + 1);
        size = std::hypot(offset, p - std::sqrt(3.0) * offset);
        benchmark::DoNotOptimize(size);
    }
    state.counters["error"] = size - exact_size();
}
BENCHMARK(sampled)->Name("cam size: sampled")->Arg(36)->Arg(90)->Arg(360)->Arg(720)->Arg(3600)->Arg(36000);

void exact(benchmark::State& state) {
    const Problem problem = parse_problem(text, "size.toml").problem;
    double size = 0;
    for (auto _ : state) {
        size = solve_in_closed_form(problem)->best->objective;
        benchmark::DoNotOptimize(size);
    }
    state.counters["error"] = size - exact_size();
}
BENCHMARK(exact)->Name("cam size: exact, with its certificate and every requirement evaluated");

}  // namespace
