#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "analysis/four_bar.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/profiles/random_number.h"
#include "synthesis/bench/profiles/success.h"
#include "synthesis/bench/profiles/traced_path.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/timing.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"

namespace mechwright::bench {

namespace {

constexpr double turn = 2 * std::numbers::pi;
/// Points are met if the root of their mean squared distance is below this part of the curve's size.
constexpr double met_within = 1e-10;

/// A random crank-rocker or drag link with at least 0.02 of Grashof margin, links from 0.2 to 1.
FourBar<double> random_linkage(std::uint64_t k) {
    for (std::uint64_t tries = 0;; ++tries) {
        const auto length = [&](std::uint64_t i) { return 0.2 * std::pow(5.0, random_number(k, 10 * tries + i)); };
        const FourBar<double> m{length(1), length(2), length(3), length(4)};
        const FourBarClass kind = classify(m).kind;
        const bool turns = kind == FourBarClass::crank_rocker || kind == FourBarClass::double_crank;
        if (turns && grashof_margin(m) > 0.02) return m;
    }
}

constexpr const char* beginning = R"(schema = 1
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
)";

TracedPath traced(std::uint64_t k, int count, bool timed) {
    const FourBar<double> m = random_linkage(k);
    const CouplerPoint<double> point{2 * random_number(k, 901) - 1, 2 * random_number(k, 902) - 1};
    const Placement<double> placement{{2 * random_number(k, 903) - 1, 2 * random_number(k, 904) - 1},
                                      turn * random_number(k, 905)};
    const double start = turn * random_number(k, 906);
    TracedPath path;
    Vector<double> first{};
    std::string points, angles;
    for (int i = 0; i < count; ++i) {
        const double angle = i * turn / count;
        const auto p = placed(position(m, point, pose(m, start + angle, Assembly::open)), placement);
        if (i == 0) first = p;
        path.size = std::max(path.size, std::hypot(p.x - first.x, p.y - first.y));
        points += fmt::format("[{:.17g}, {:.17g}], ", p.x, p.y);
        angles += fmt::format("{:.17g}, ", 360.0 * i / count);
    }
    path.text = std::string(beginning) + (timed ? "crank-start = { min = 0, max = 360 }\n" : "") +
                "[path]\nclosed = true\npoints = [" + points + "]\n" +
                (timed ? "timing = \"prescribed\"\ncrank_angles = [" + angles + "]\n" : "timing = \"free\"\n") +
                "[objective]\nminimize = \"path-rms\"\n";
    return path;
}

std::vector<Row> measured(int count, bool is_timed, int linkages, const Effort& effort,
                          const std::function<TracedPath(std::uint64_t)>& traced_path) {
    RunOptions options;
    options.jobs = effort.jobs;
    options.stop = effort.stop;
    int met = 0;
    std::vector<double> seconds;
    for (int k = 0; k < linkages && !effort.stopped(); ++k) {
        const TracedPath path = traced_path(static_cast<std::uint64_t>(k));
        const Problem problem = parse_problem(path.text, "path.toml").problem;
        const Result result = solve(problem, options);
        met += result.status == Status::solved && result.best->objective <= met_within * path.size;
        seconds.push_back(result.search.seconds);
    }
    if (seconds.empty()) return {};
    const double slowest = *std::max_element(seconds.begin(), seconds.end());
    return {{count, is_timed ? "prescribed" : "free", linkages, met, timing_of(seconds).median, slowest}};
}

std::vector<Measurement> recovery_measurements(const Effort&) {
    std::vector<Measurement> all;
    for (const int count : {10, 25, 100})
        for (const bool is_timed : {true, false})
            all.push_back({fmt::format("{} points, {}", count, is_timed ? "timed" : "untimed"),
                           [count, is_timed](const Effort& e) {
                               return measured(count, is_timed, e.pick(10, 200), e,
                                               [&](std::uint64_t k) { return traced(k, count, is_timed); });
                           }});
    constexpr int on_six_bars = 30;
    for (const bool is_timed : {true, false})
        for (const bool watt : {true, false})
            all.push_back(
                {fmt::format("six-bars of {}, {} points, {}", watt ? "Watt's first kind" : "Stephenson's third kind",
                             on_six_bars, is_timed ? "timed" : "untimed"),
                 [is_timed, watt](const Effort& e) {
                     return measured(on_six_bars, is_timed, e.pick(2, 40), e,
                                     [&](std::uint64_t k) { return traced_six_bar(k, watt, on_six_bars, is_timed); });
                 }});
    return all;
}

std::string recovery_chapter(const Sheet& sheet) {
    MarkdownTable table{{"path", "linkages", "met", "95 % interval", "median time", "slowest"}, {}};
    for (const Row& row : sheet.rows) {
        const double linkages = sheet.number(row, "linkages"), met = sheet.number(row, "met");
        const Interval95 interval = wilson(met, linkages);
        table.rows.push_back({sheet.text(row, "path"), fmt::format("{:.0f}", linkages),
                              fmt::format("{:.1f} %", 100 * met / linkages),
                              fmt::format("{:.1f} to {:.1f} %", 100 * interval.lower, 100 * interval.upper),
                              time_text(sheet.number(row, "seconds")), time_text(sheet.number(row, "slowest"))});
    }
    return "Points of random crank-rockers, drag links and six-bars, their curves once round, with every dimension to "
           "be "
           "found: a "
           "design\ncounts that meets all of them to 1e-10 of the curve's size and is verified. Default options, cold, "
           "all threads.\n\n" +
           to_markdown(table);
}

std::vector<Diagram> recovery_diagrams(const Sheet&) { return {}; }

}  // namespace

Section recovery() {
    return {"recovery",
            "Random linkages found again from their paths",
            {"path", "points", "timing", "linkages", "met", "seconds", "slowest"},
            recovery_measurements,
            recovery_chapter,
            recovery_diagrams};
}

}  // namespace mechwright::bench
