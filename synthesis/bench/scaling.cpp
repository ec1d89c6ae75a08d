#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "synthesis/bench/fitted_power.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/program_times.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/shipped.h"
#include "synthesis/problem/reader.h"
#include "synthesis/report/files/run_program.h"
#include "synthesis/report/files/temporary_folder.h"
#include "synthesis/solve/solve.h"

namespace mechwright::bench {

namespace {

constexpr const char* timed_value = "value of a timed path";
constexpr const char* timed_gradient = "gradient of a timed path";
constexpr const char* untimed_value = "value of an untimed path";
constexpr const char* untimed_gradient = "gradient of an untimed path";
constexpr const char* untimed_hessian = "Hessian of an untimed path";
constexpr const char* solve_points = "solution of a timed path";
constexpr const char* gradient_of_free = "gradient of a path of 24 points";
constexpr const char* solve_free = "solution of a path of 24 points";
constexpr const char* solve_starts = "solution of a drag link";
constexpr const char* solve_threads = "solution of a path";
constexpr const char* study_points = "study of four-bars";

struct FreeDimension {
    std::string_view name;
    double min, max;
    double given;  ///< where it is not free
};

/// Those of a timed path, in the order in which they come to be free.
constexpr std::array<FreeDimension, 10> path_dimensions{{{"origin-x", -100, 100, 0},
                                                         {"origin-y", -100, 100, 0},
                                                         {"tilt", 0, 360, 20},
                                                         {"crank-start", 0, 360, 40},
                                                         {"point-along", -100, 100, 50},
                                                         {"point-across", -100, 100, 30},
                                                         {"coupler", 20, 200, 100},
                                                         {"rocker", 20, 200, 100},
                                                         {"ground", 20, 200, 110},
                                                         {"crank", 5, 60, 30}}};

/// An ellipse that no four-bar draws, by as many of the dimensions as are free.
Problem ellipse(int count, bool is_timed, std::size_t free = path_dimensions.size()) {
    std::string points, angles, dimensions;
    for (int i = 0; i < count; ++i) {
        const double t = 2 * std::numbers::pi * i / count;
        points += fmt::format("[{:.17g}, {:.17g}], ", 40 * std::cos(t), 25 * std::sin(t));
        angles += fmt::format("{:.17g}, ", 360.0 * i / count);
    }
    for (std::size_t i = 0; i < path_dimensions.size(); ++i) {
        const FreeDimension& d = path_dimensions[i];
        if (d.name == "crank-start" && !is_timed) continue;
        dimensions += i < free ? fmt::format("{} = {{ min = {}, max = {} }}\n", d.name, d.min, d.max)
                               : fmt::format("{} = {}\n", d.name, d.given);
    }
    const std::string text = fmt::format(
        R"(schema = 1
mechanism = "four-bar"
[dimensions]
{}[path]
closed = true
points = [{}]
{}
[objective]
minimize = "path-sse"
)",
        dimensions, points,
        is_timed ? "timing = \"prescribed\"\ncrank_angles = [" + angles + "]" : "timing = \"free\"");
    return parse_problem(text, "ellipse.toml").problem;
}

Row row_of(const char* series, double size, const Timing& t) { return {series, size, t.median, t.lower, t.upper}; }

std::vector<Row> evaluations(const Effort& effort, int points) {
    const Problem timed_path = ellipse(points, true), untimed_path = ellipse(points, false);
    const auto with = program_point(timed_path), without = program_point(untimed_path);
    if (!with || !without) return {};
    const auto t = timed({values(*with), values_and_gradients(*with), values(*without), values_and_gradients(*without),
                          hessians(*without)},
                         effort.pick(5, 9), effort.pick(0.04, 0.5));
    return {row_of(timed_value, points, t[0]), row_of(timed_gradient, points, t[1]),
            row_of(untimed_value, points, t[2]), row_of(untimed_gradient, points, t[3]),
            row_of(untimed_hessian, points, t[4])};
}

std::vector<Row> gradient_of(const Effort& effort, std::size_t free) {
    const Problem path = ellipse(24, true, free);
    const auto at = program_point(path);
    if (!at) return {};
    const auto t = timed({values_and_gradients(*at)}, effort.pick(5, 9), effort.pick(0.04, 0.5));
    return {row_of(gradient_of_free, static_cast<double>(free), t[0])};
}

std::vector<Row> solutions(const Effort& effort, const char* series, double size, const Problem& problem, int jobs) {
    RunOptions options;
    options.jobs = jobs;
    options.stop = effort.stop;
    return {row_of(series, size, timed([&] { solve(problem, options); }, effort.pick(1, 5)))};
}

/// On one core, in time of the processor.
std::vector<Row> solutions_on_one_core(const Effort& effort, const char* series, double size, const Problem& problem) {
    RunOptions options;
    options.stop = effort.stop;
    return {row_of(series, size, timed_on_this_thread([&] { solve(problem, options); }, effort.pick(1, 5)))};
}

/// The text of a study with another number of points.
std::string with_count(std::string text, int count) {
    std::istringstream lines(text);
    std::string changed;
    for (std::string line; std::getline(lines, line);)
        changed += (line.starts_with("count") ? fmt::format("count = {}", count) : line) + "\n";
    return changed;
}

/// The program itself on one core, from its start to the last row of the data.
std::vector<Row> study(const Effort& effort, int count) {
    const TemporaryFolder folder;
    std::ifstream shipped(effort.problems / "studies" / "random-four-bars.toml");
    const std::string text((std::istreambuf_iterator<char>(shipped)), {});
    const std::string file = folder.path / "study.toml";
    std::ofstream(file) << with_count(text, count);
    bool succeeded = true;
    int run = 0;
    const Timing t = timed(
        [&] {
            if (effort.stopped()) return;
            const std::string out = folder.path / std::to_string(run++);
            succeeded =
                succeeded &&
                run_program({effort.program, "study", file, "--out", out, "--quiet", "--jobs", "1"}, "").succeeded();
        },
        effort.pick(1, 3));
    if (!succeeded) return {};
    return {row_of(study_points, count, t)};
}

std::vector<int> thread_counts(int most) {
    std::vector<int> counts;
    for (int n = 1; n <= most; n *= 2)
        counts.push_back(n);
    return counts;
}

std::vector<Measurement> scaling_measurements(const Effort& effort) {
    std::vector<Measurement> all;
    for (const int points : {6, 12, 24, 48, 96}) {
        all.push_back({fmt::format("program of {} points", points),
                       [points](const Effort& e) { return evaluations(e, points); }});
    }
    for (const int points : {6, 12, 24, 48, 96})
        all.push_back({fmt::format("{} of {} points", solve_points, points), [points](const Effort& e) {
                           return solutions_on_one_core(e, solve_points, points, ellipse(points, true));
                       }});
    for (const std::size_t free : {2, 4, 6, 8, 10}) {
        all.push_back({fmt::format("{}, {} free", gradient_of_free, free),
                       [free](const Effort& e) { return gradient_of(e, free); }});
        all.push_back({fmt::format("{}, {} free", solve_free, free), [free](const Effort& e) {
                           return solutions_on_one_core(e, solve_free, static_cast<double>(free),
                                                        ellipse(24, true, free));
                       }});
    }
    for (const int starts : {8, 16, 32, 64, 128})
        all.push_back({fmt::format("{}, {}", solve_starts, starts), [starts](const Effort& e) -> std::vector<Row> {
                           auto problem = shipped_problem(e.problems, "quick-return/uniform-speed-drag-link");
                           if (!problem) return {};
                           problem->solver.starts = starts;
                           return solutions_on_one_core(e, solve_starts, starts, *problem);
                       }});
    for (const int jobs : thread_counts(effort.jobs))
        all.push_back({fmt::format("{}, {}", solve_threads, jobs), [jobs](const Effort& e) -> std::vector<Row> {
                           const auto problem = shipped_problem(e.problems, "path/yu1");
                           if (!problem) return {};
                           return solutions(e, solve_threads, jobs, *problem, jobs);
                       }});
    for (const int count : effort.pick(std::vector{100, 400, 1600}, std::vector{100, 1000, 10'000}))
        all.push_back(
            {fmt::format("{}, {}", study_points, count), [count](const Effort& e) { return study(e, count); }});
    return all;
}

/// What grows, and with what.
struct Series {
    const char* name;
    const char* over;
};
constexpr std::array all_series{Series{timed_value, "points"},
                                Series{timed_gradient, "points"},
                                Series{untimed_value, "points"},
                                Series{untimed_gradient, "points"},
                                Series{untimed_hessian, "points"},
                                Series{solve_points, "points"},
                                Series{gradient_of_free, "free dimensions"},
                                Series{solve_free, "free dimensions"},
                                Series{solve_starts, "local searches"},
                                Series{solve_threads, "threads"},
                                Series{study_points, "points of the study"}};

std::vector<std::pair<double, double>> points_of(const Sheet& sheet, const char* series) {
    std::vector<std::pair<double, double>> points;
    for (const Row& row : sheet.where("series", series))
        points.emplace_back(sheet.number(row, "size"), sheet.number(row, "seconds"));
    return points;
}

MarkdownTable table(const Sheet& sheet) {
    MarkdownTable table{{"time of", "over", "from", "to", "times so much", "takes", "grows with the power"}, {}};
    for (const Series& series : all_series) {
        const auto points = points_of(sheet, series.name);
        if (points.size() < 2) continue;
        const auto at = [](const std::pair<double, double>& p) {
            return fmt::format("{}: {}", whole_number(p.first), time_text(p.second));
        };
        table.rows.push_back({series.name, series.over, at(points.front()), at(points.back()),
                              ratio_text(points.back().first / points.front().first),
                              ratio_text(points.back().second / points.front().second),
                              significant(fitted_power(points).exponent, 2)});
    }
    return table;
}

/// "2 threads take 0.52 times as long as one."
std::string threads_text(const Sheet& sheet) {
    std::string text;
    const auto points = points_of(sheet, solve_threads);
    for (std::size_t i = 1; i < points.size(); ++i)
        text += fmt::format(" {} threads solve a path in {} of the time of one, {} of what they could at best.",
                            whole_number(points[i].first), significant(points[i].second / points[0].second, 2),
                            significant(points[0].second / points[i].second / points[i].first, 2));
    return text;
}

std::string scaling_chapter(const Sheet& sheet) {
    return "How times grow with the size of what is asked. An untimed path has a variable more for each point. Where "
           "few "
           "dimensions are free, they come to be so in this order: place, tilt and crank angle, coupler point, links. "
           "Powers are fitted over all sizes that were measured; 1 is in proportion.\n\n" +
           to_markdown(table(sheet)) +
           fmt::format(
               "\nThe gradient of a timed path grows with the power {} of its points, that of an untimed one, which "
               "has as many more variables, with the power {}.{} The time of a study is that of the whole program, "
               "from its start to the data on disk.\n",
               significant(fitted_power(points_of(sheet, timed_gradient)).exponent, 2),
               significant(fitted_power(points_of(sheet, untimed_gradient)).exponent, 2), threads_text(sheet));
}

Diagram diagram(const Sheet& sheet, const char* name, const char* title, const char* x,
                std::initializer_list<const char*> series) {
    Diagram d;
    d.name = name;
    d.title = title;
    d.x = x;
    d.y = "s";
    d.log_x = d.log_y = true;
    for (const char* s : series)
        d.curves.push_back({s, points_of(sheet, s)});
    return d;
}

std::vector<Diagram> scaling_diagrams(const Sheet& sheet) {
    return {diagram(sheet, "scaling-points", "Time over the points of a path", "points",
                    {timed_value, timed_gradient, untimed_value, untimed_gradient, untimed_hessian, solve_points}),
            diagram(sheet, "scaling-runs", "Time of whole runs",
                    "free dimensions, local searches, threads, points of the study",
                    {solve_free, solve_starts, solve_threads, study_points})};
}

}  // namespace

Section scaling() {
    return {"scaling",
            "Scaling: time over the size of the problem",
            {"measurement", "series", "size", "seconds", "lower", "upper"},
            scaling_measurements,
            scaling_chapter,
            scaling_diagrams};
}

}  // namespace mechwright::bench
