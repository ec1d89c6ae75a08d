#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/profiles/random_number.h"
#include "synthesis/bench/profiles/success.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/timing.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"

namespace mechwright::bench {

namespace {

/// Answers of two seeds that agree to this part are the same.
constexpr double same_within = 1e-6;

constexpr const char* four_bar_links = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 1, max = 60 }
crank = { min = 1, max = 60 }
coupler = { min = 1, max = 60 }
rocker = { min = 1, max = 60 }
assembly = "either"
)";
constexpr const char* slider_crank_links = R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank = { min = 1, max = 60 }
rod = { min = 1, max = 60 }
offset = { min = -60, max = 60 }
)";
constexpr const char* placed = R"(point-along = { min = -60, max = 60 }
point-across = { min = -60, max = 60 }
origin-x = { min = -60, max = 60 }
origin-y = { min = -60, max = 60 }
tilt = { min = 0, max = 360 }
)";

/// A way across 20 mm with three waves of random heights, in so many points.
std::string waves(std::uint64_t k, int count) {
    std::string points;
    for (int i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / (count - 1);
        double height = 0;
        for (std::uint64_t wave = 1; wave <= 3; ++wave)
            height += (10 * random_number(k, wave) - 5) * std::sin(static_cast<double>(wave) * std::numbers::pi * part);
        points += fmt::format("[{:.4f}, {:.4f}], ", 20 * part, height);
    }
    return points;
}

std::string open_path(std::uint64_t k, std::string_view timing) {
    const int count = 7 + static_cast<int>(10 * random_number(k, 10));
    return fmt::format("[path]\npoints = [{}]\ntiming = \"{}\"\n[objective]\nminimize = \"path-{}\"\n", waves(k, count),
                       timing, random_number(k, 11) < 0.5 ? "rms" : "max");
}

/// Six to ten poses on a wavy way, turned from one to the next by 2 to 15 deg.
std::string poses(std::uint64_t k) {
    const int count = 6 + static_cast<int>(5 * random_number(k, 10));
    double angle = 360 * random_number(k, 20);
    std::string list;
    for (int i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / (count - 1);
        list += fmt::format("[{:.3f}, {:.3f}, {:.3f}], ", 20 * part,
                            6 * (random_number(k, 1) - 0.5) * std::sin(2 * std::numbers::pi * part), angle);
        angle += 2 + 13 * random_number(k, 21 + static_cast<std::uint64_t>(i));
    }
    return fmt::format(
        "body-angle = {{ min = 0, max = 360 }}\n[poses]\nposes = [{}]\nlength = 10\n[objective]\n"
        "minimize = \"pose-{}\"\n",
        list, random_number(k, 11) < 0.5 ? "rms" : "max");
}

/// An oval with a dent, at even crank angles.
std::string timed_oval(std::uint64_t k) {
    const int count = 8 + static_cast<int>(9 * random_number(k, 10));
    const double width = 2 + 4 * random_number(k, 1), height = 2 + 4 * random_number(k, 2);
    const double dent = random_number(k, 3) - 0.5;
    std::string points, angles;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        points += fmt::format("[{:.4f}, {:.4f}], ", width * std::cos(angle) + dent * std::cos(2 * angle),
                              height * std::sin(angle));
        angles += fmt::format("{:.9f}, ", 360.0 * i / count);
    }
    return fmt::format(
        "crank-start = {{ min = 0, max = 360 }}\n[path]\npoints = [{}]\ntiming = \"prescribed\"\n"
        "crank_angles = [{}]\n[objective]\nminimize = \"path-rms\"\n",
        points, angles);
}

struct Task {
    std::string_view name;
    std::string (*written)(std::uint64_t k);
};

constexpr std::array<Task, 4> tasks{{{"poses", poses},
                                     {"open path", [](std::uint64_t k) { return open_path(k, "free"); }},
                                     {"untimed path", [](std::uint64_t k) { return open_path(k, "none"); }},
                                     {"timed oval", timed_oval}}};

/// What two seeds come to.
std::vector<Row> measured(const Task& task, bool four_bar, const Effort& effort) {
    const int problems = effort.pick(1, 25);
    RunOptions options;
    options.jobs = effort.jobs;
    options.stop = effort.stop;
    int solved = 0, unverified = 0, alike = 0;
    std::vector<double> seconds;
    for (int k = 0; k < problems && !effort.stopped(); ++k) {
        const std::string text = (four_bar ? four_bar_links : slider_crank_links) + std::string(placed) +
                                 task.written(static_cast<std::uint64_t>(k));
        Problem problem = parse_problem(text, "everyday.toml").problem;
        std::array<double, 2> objective{};
        for (std::size_t seed = 0; seed < 2; ++seed) {
            problem.solver.seed = seed + 1;
            const Result result = solve(problem, options);
            solved += result.status == Status::solved;
            unverified += result.status == Status::unverified;
            objective[seed] = result.best ? result.best->objective : -static_cast<double>(seed);
            seconds.push_back(result.search.seconds);
        }
        alike += std::abs(objective[0] - objective[1]) <= same_within * std::abs(objective[0]);
    }
    if (seconds.empty()) return {};
    const double slowest = *std::max_element(seconds.begin(), seconds.end());
    return {{problems, 2 * problems, solved, unverified, alike, timing_of(seconds).median, slowest}};
}

std::vector<Measurement> everyday_measurements(const Effort&) {
    std::vector<Measurement> all;
    for (const bool four_bar : {true, false})
        for (const Task& task : tasks)
            all.push_back({fmt::format("{}, {}", four_bar ? "four-bar" : "slider-crank", task.name),
                           [&task, four_bar](const Effort& e) { return measured(task, four_bar, e); }});
    return all;
}

std::string everyday_chapter(const Sheet& sheet) {
    MarkdownTable table{
        {"task", "runs", "solved", "95 % interval", "unverified", "two seeds agree", "median time", "slowest"}, {}};
    for (const Row& row : sheet.rows) {
        const double runs = sheet.number(row, "runs"), solved = sheet.number(row, "solved");
        const Interval95 interval = wilson(solved, runs);
        table.rows.push_back(
            {sheet.text(row, "task"), fmt::format("{:.0f}", runs), fmt::format("{:.0f}", solved),
             fmt::format("{:.1f} to {:.1f} %", 100 * interval.lower, 100 * interval.upper),
             fmt::format("{:.0f}", sheet.number(row, "unverified")),
             fmt::format("{:.0f} of {:.0f}", sheet.number(row, "alike"), sheet.number(row, "problems")),
             time_text(sheet.number(row, "seconds")), time_text(sheet.number(row, "slowest"))});
    }
    return "Random tasks that no linkage fulfils exactly, with every dimension to be found, each from two seeds: how "
           "many\n"
           "end with a verified design, how many with one that is not to be used (exit code 7, of which there should "
           "be\n"
           "none), and how often both seeds come to the same to a millionth. Default options, cold, all threads.\n\n" +
           to_markdown(table);
}

std::vector<Diagram> everyday_diagrams(const Sheet&) { return {}; }

}  // namespace

Section everyday() {
    return {"everyday",
            "Everyday tasks",
            {"task", "problems", "runs", "solved", "unverified", "alike", "seconds", "slowest"},
            everyday_measurements,
            everyday_chapter,
            everyday_diagrams};
}

}  // namespace mechwright::bench
