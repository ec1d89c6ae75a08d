// The kernels of cams: a law, and a follower's contact with its derivatives of the lift known.

#include <benchmark/benchmark.h>

#include <cmath>

#include "analysis/cam/flat_follower.h"
#include "analysis/cam/roller_follower.h"
#include "analysis/cam/segment.h"

namespace {

using namespace mechwright;
using namespace mechwright::cam;

struct Moving {
    double u = 0;
    double next() {
        u += 0.618033988749895;
        return u -= std::floor(u);
    }
};

template <class Measure>
void measure(benchmark::State& state, const Measure& f) {
    Moving place;
    for (auto _ : state)
        benchmark::DoNotOptimize(f(place.next()));
    state.SetItemsProcessed(state.iterations());
}

const Segment<double> cycloidal{SegmentKind::rise, {SegmentLaw::Form::law, Law::cycloidal, false}, 1.5, 20};
const Segment<double> polynomial{SegmentKind::rise, {SegmentLaw::Form::law, Law::polynomial_4567, false}, 1.5, 20};
const Segment<double> swinging{SegmentKind::rise, {SegmentLaw::Form::law, Law::cycloidal, false}, 1.5, 0.4};

void lifts(benchmark::State& state) {
    measure(state, [](double u) { return lift_at(cycloidal, 0, u, 0.0); });
}
BENCHMARK(lifts)->Name("cam: cycloidal lift to jerk");

void polynomials(benchmark::State& state) {
    measure(state, [](double u) { return lift_at(polynomial, 0, u, 0.0); });
}
BENCHMARK(polynomials)->Name("cam: 4-5-6-7 lift to jerk");

void rollers(benchmark::State& state) {
    const TranslatingRoller<double> f{40, 5, 8, 1};
    measure(state, [&](double u) {
        const auto p = pitch_point(f, lift_at(cycloidal, 0, u, 0.0));
        return pressure_angle(p) + curvature(p);
    });
}
BENCHMARK(rollers)->Name("cam: roller, lift to pressure angle and curvature");

void arms(benchmark::State& state) {
    const OscillatingRoller<double> f{36, 93, 80, 8, 1};
    measure(state, [&](double u) {
        const auto p = pitch_point(f, lift_at(swinging, 0, u, 0.0));
        return pressure_angle(p) + curvature(p);
    });
}
BENCHMARK(arms)->Name("cam: oscillating roller, the same");

void faces(benchmark::State& state) {
    const TranslatingFlat<double> f{40, 1};
    measure(state, [&](double u) { return face_contact(f, lift_at(cycloidal, 0, u, 0.0)); });
}
BENCHMARK(faces)->Name("cam: flat face, contact and radius");

}  // namespace
