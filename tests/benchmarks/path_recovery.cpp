// Paths whose best design is known, because a linkage made them: how many of 200 random ones are met again to 1e-10 of
// their size, with all default options, and how long that takes. The whole campaign takes minutes; it is not part of
// what the tests run.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "analysis/four_bar.h"
#include "synthesis/problem/reader.h"
#include "synthesis/search/low_discrepancy.h"
#include "synthesis/search/solve.h"

namespace {

using namespace mechwright;

constexpr double turn = 2 * std::numbers::pi;

struct Target {
    std::vector<Vector<double>> points;
    double size = 0;
    std::string text;
};

/// A number in (0, 1) of linkage k.
double drawn(std::uint64_t k, std::uint64_t i) {
    return std::ldexp(static_cast<double>(mixed(mixed(k) ^ (i * 7919)) >> 11) + 0.5, -53);
}

/// A random crank-rocker or drag link with at least 0.02 of Grashof margin, links from 0.2 to 1.
FourBar<double> random_linkage(std::uint64_t k) {
    for (std::uint64_t tries = 0;; ++tries) {
        const auto length = [&](std::uint64_t i) { return 0.2 * std::pow(5.0, drawn(k, 10 * tries + i)); };
        const FourBar<double> m{length(1), length(2), length(3), length(4)};
        const FourBarClass kind = classify(m).kind;
        const bool turns = kind == FourBarClass::crank_rocker || kind == FourBarClass::double_crank;
        if (turns && grashof_margin(m) > 0.02) return m;
    }
}

Target target_of(std::uint64_t k, int count, bool timed) {
    const FourBar<double> m = random_linkage(k);
    const CouplerPoint<double> point{2 * drawn(k, 901) - 1, 2 * drawn(k, 902) - 1};
    const Placement<double> placement{{2 * drawn(k, 903) - 1, 2 * drawn(k, 904) - 1}, turn * drawn(k, 905)};
    const double start = turn * drawn(k, 906);
    Target target;
    std::string points;
    std::string angles;
    for (int i = 0; i < count; ++i) {
        const double angle = i * turn / count;
        const auto p = placed(position(m, point, pose(m, start + angle, Assembly::open)), placement);
        target.points.push_back(p);
        target.size = std::max(target.size, std::hypot(p.x - target.points[0].x, p.y - target.points[0].y));
        points += fmt::format("[{:.17g}, {:.17g}], ", p.x, p.y);
        angles += fmt::format("{:.17g}, ", 360.0 * i / count);
    }
    target.text = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 0, max = 10 }
crank = { min = 0, max = 10 }
coupler = { min = 0, max = 10 }
rocker = { min = 0, max = 10 }
point-along = { min = -10, max = 10 }
point-across = { min = -10, max = 10 }
origin-x = { min = -10, max = 10 }
origin-y = { min = -10, max = 10 }
tilt = { min = 0, max = 360 }
assembly = "either"
)" + std::string(timed ? "crank-start = { min = 0, max = 360 }\n" : "") +
                  "[path]\nclosed = true\npoints = [" + points + "]\n" +
                  (timed ? "timing = \"prescribed\"\ncrank_angles = [" + angles + "]\n" : "timing = \"free\"\n") +
                  "[objective]\nminimize = \"path-rms\"\n";
    return target;
}

void recovery(benchmark::State& state) {
    const auto count = static_cast<int>(state.range(0));
    const bool timed = state.range(1) != 0;
    constexpr int linkages = 200;
    int met = 0;
    int verified = 0;
    std::vector<double> seconds;
    for (auto _ : state) {
        for (std::uint64_t k = 0; k < linkages; ++k) {
            const Target target = target_of(k, count, timed);
            const Problem problem = parse_problem(target.text, "path.toml").problem;
            RunOptions options;
            options.jobs = 2;
            const Result result = solve(problem, options);
            verified += result.status == Status::solved;
            met += result.status == Status::solved && result.best->objective <= 1e-10 * target.size;
            seconds.push_back(result.search.seconds);
        }
    }
    std::sort(seconds.begin(), seconds.end());
    state.counters["met %"] = 100.0 * met / linkages;
    state.counters["verified %"] = 100.0 * verified / linkages;
    state.counters["median ms"] = 1e3 * seconds[seconds.size() / 2];
    state.counters["slowest ms"] = 1e3 * seconds.back();
}
BENCHMARK(recovery)
    ->Name("campaign: paths of random linkages, points/timed")
    ->ArgsProduct({{10, 25, 100}, {1, 0}})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
