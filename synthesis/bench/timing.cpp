#include "synthesis/bench/timing.h"

#include <time.h>

#include <algorithm>
#include <array>
#include <string>

namespace mechwright::bench {

namespace {

/// Keeps the time of every repetition; a piece is named by its number.
struct Collected : benchmark::BenchmarkReporter {
    std::vector<std::vector<double>> seconds;

    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration && !run.error_occurred && run.iterations > 0)
                seconds[std::stoul(run.run_name.function_name)].push_back(run.cpu_accumulated_time /
                                                                          static_cast<double>(run.iterations));
    }
};

void set_up_once() {
    static const bool done = [] {
        std::array<std::string, 2> words{"bench", "--benchmark_enable_random_interleaving=true"};
        std::array<char*, 3> arguments{words[0].data(), words[1].data(), nullptr};
        int count = 2;
        benchmark::Initialize(&count, arguments.data());
        return true;
    }();
    static_cast<void>(done);
}

}  // namespace

Timing timing_of(std::vector<double> seconds) {
    if (seconds.empty()) return {};
    std::sort(seconds.begin(), seconds.end());
    const auto at = [&](double part) {
        return seconds[static_cast<std::size_t>(part * static_cast<double>(seconds.size() - 1) + 0.5)];
    };
    return {at(0.5), at(0.25), at(0.75)};
}

std::vector<Timing> timed(const std::vector<Piece>& pieces, int repetitions, double least_seconds) {
    set_up_once();
    Collected collected;
    collected.seconds.resize(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
        benchmark::RegisterBenchmark(std::to_string(i).c_str(), pieces[i])
            ->MinTime(least_seconds / repetitions)
            ->Repetitions(repetitions);
    benchmark::RunSpecifiedBenchmarks(&collected);
    benchmark::ClearRegisteredBenchmarks();
    std::vector<Timing> timings;
    for (auto& seconds : collected.seconds)
        timings.push_back(timing_of(std::move(seconds)));
    return timings;
}

namespace {

template <class Now>
Timing timed_by(const Now& now, const std::function<void()>& call, int repetitions) {
    std::vector<double> seconds;
    for (int i = 0; i < repetitions; ++i) {
        const double begin = now();
        call();
        seconds.push_back(now() - begin);
    }
    return timing_of(std::move(seconds));
}

double seconds_of(clockid_t clock) {
    timespec now{};
    ::clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Timing timed(const std::function<void()>& call, int repetitions) {
    return timed_by([] { return seconds_of(CLOCK_MONOTONIC); }, call, repetitions);
}

Timing timed_on_this_thread(const std::function<void()>& call, int repetitions) {
    return timed_by([] { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }, call, repetitions);
}

}  // namespace mechwright::bench
