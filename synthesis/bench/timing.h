#pragma once
/// \file
/// How long something takes: short pieces by Google Benchmark, in random order, long ones by the clock.

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

namespace mechwright::bench {

/// Seconds of one call.
struct Timing {
    double median = 0;
    double lower = 0;  ///< quartiles
    double upper = 0;
};

Timing timing_of(std::vector<double> seconds);

/// A piece that is timed: runs `for (auto _ : state)` over what takes the time.
using Piece = std::function<void(benchmark::State&)>;

/// A piece that calls f(k) with k = 0, 1, ... and keeps what it gives from being optimised away.
template <class F>
Piece piece(F f) {
    return [f](benchmark::State& state) mutable {
        std::size_t k = 0;
        for (auto _ : state)
            benchmark::DoNotOptimize(f(k++));
    };
}

/// The pieces, each repeated so many times for at least so many seconds, all repetitions in random order: a machine
/// that is slow for a moment is slow for all of them.
std::vector<Timing> timed(const std::vector<Piece>& pieces, int repetitions, double least_seconds);

/// The time of `repetitions` calls, for what takes milliseconds or more.
Timing timed(const std::function<void()>& call, int repetitions);

/// The same in time of the processor, for what runs on the calling thread alone: whatever else the machine does.
Timing timed_on_this_thread(const std::function<void()>& call, int repetitions);

}  // namespace mechwright::bench
