#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "synthesis/bench/fitted_power.h"
#include "synthesis/bench/linkages/swarm.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/profiles/traced_path.h"
#include "synthesis/bench/program_times.h"
#include "synthesis/bench/sections.h"
#include "synthesis/problem/reader.h"
#include "synthesis/report/files/run_program.h"
#include "synthesis/report/files/temporary_folder.h"
#include "synthesis/solve/solve.h"

namespace mechwright::bench {

namespace {

constexpr const char* cold = "a six-bar, cold start to verified design";
constexpr const char* cold_processor = "the same, processor";
constexpr const char* over_links[]{"value over links", "value and gradient over links"};
constexpr const char* over_points[]{"value over points", "value and gradient over points"};
constexpr const char* solved_over_links = "solution over links";
constexpr const char* solved_over_points = "solution over points";
constexpr const char* ours = "the program's default";
constexpr int usual_points = 30;
/// Points are met if the root of their mean squared distance is below this part of the curve's size.
constexpr double met_to = 1e-10;
/// What a design that does not assemble counts for, in sizes of the path.
constexpr double worth_nothing = 1e6;

TracedPath timed_six_bar(int k) {
    return traced_six_bar(static_cast<std::uint64_t>(k / 2), k % 2 == 0, usual_points, true);
}

Row row_of(const char* series, double size, const Timing& t, double evaluations, int met, int of, double error) {
    return {series, size, t.median, t.lower, t.upper, evaluations, met, of, error};
}

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double processor_seconds_of_children() {
    rusage used{};
    ::getrusage(RUSAGE_CHILDREN, &used);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// The whole program, from its start to a design that is verified.
std::vector<Row> cold_starts(const Effort& effort) {
    const TemporaryFolder folder;
    const std::string file = folder.path / "six-bar.toml";
    const int count = effort.pick(4, 40);
    int met = 0;
    std::vector<double> wall, processor;
    for (int k = 0; k < count && !effort.stopped(); ++k) {
        const TracedPath path = timed_six_bar(k);
        std::ofstream(file) << path.text;
        const double before = processor_seconds_of_children();
        ProgramRun run;
        wall.push_back(timed(
                           [&] {
                               run = run_program({effort.program, "solve", file, "--json"}, "", true);
                           },
                           1)
                           .median);
        processor.push_back(processor_seconds_of_children() - before);
        const auto document = nlohmann::json::parse(run.output, nullptr, false);
        met += run.succeeded() && !document.is_discarded() &&
               document.at("objective").at("value").get<double>() <= met_to * path.size;
    }
    return {row_of(cold, usual_points, timing_of(wall), nothing, met, count, nothing),
            row_of(cold_processor, usual_points, timing_of(processor), nothing, met, count, nothing)};
}

std::vector<Row> evaluations(const Effort& effort, const TracedPath& path, int size, const char* const (&series)[2]) {
    const Problem problem = parse_problem(path.text, "path.toml").problem;
    const auto at = program_point(problem);
    if (!at) return {};
    const auto t = timed({values(*at), values_and_gradients(*at)}, effort.pick(5, 9), effort.pick(0.04, 0.5));
    return {row_of(series[0], size, t[0], nothing, 0, 0, nothing),
            row_of(series[1], size, t[1], nothing, 0, 0, nothing)};
}

/// What our own search comes to, on one core.
struct Ours {
    double seconds, evaluations, error;  ///< of the processor; the error in sizes of the path
    bool met;
};

Ours solved_by_default(const Effort& effort, const TracedPath& path) {
    Problem problem = parse_problem(path.text, "path.toml").problem;
    problem.solver.time_limit = effort.pick(20, 120);
    RunOptions options;
    options.stop = effort.stop;
    Result result;
    const Timing t = timed_on_this_thread([&] { result = solve(problem, options); }, 1);
    const double error = result.best ? result.best->objective / path.size : worth_nothing;
    return {t.median, static_cast<double>(result.search.drawn + result.search.evaluations), error,
            result.status == Status::solved && error <= met_to};
}

/// So many paths of a size.
std::vector<Row> solutions(const Effort& effort, const char* series, int size,
                           const std::function<TracedPath(int)>& path_of) {
    std::vector<double> seconds, used, errors;
    int met = 0;
    const int count = effort.pick(1, 9);
    for (int k = 0; k < count && !effort.stopped(); ++k) {
        const Ours one = solved_by_default(effort, path_of(k));
        seconds.push_back(one.seconds);
        used.push_back(one.evaluations);
        errors.push_back(one.error);
        met += one.met;
    }
    return {row_of(series, size, timing_of(seconds), timing_of(used).median, met, count, timing_of(errors).median)};
}

/// The error of a path by the program's own variables, with the placement among them, in sizes of the path.
BoxedError error_of(const Program& program, double size) {
    BoxedError error;
    for (const Variable& v : program.variables) {
        error.lower.push_back(v.lower);
        error.upper.push_back(v.upper);
    }
    const double per = 1 / (size * std::sqrt(static_cast<double>(program.targets.size())));
    error.at = [&program, per, rest = PathResiduals()](const std::vector<double>& x) mutable {
        const Eigen::Map<const Eigen::VectorXd> point(x.data(), static_cast<Eigen::Index>(x.size()));
        return path_residuals(program, point, false, rest) ? rest.value.norm() * per : worth_nothing;
    };
    return error;
}

/// What others get: as many as pylinkage takes by default, and about as many as our own search.
constexpr std::array<long, 2> evaluations_of_peers{20'000, 1'000'000};

/// Others on the same six-bars.
std::vector<Row> by_peer(const Effort& effort, const PeerOfLinkages& peer, long most) {
    std::vector<double> seconds, errors;
    int met = 0;
    const int count = effort.pick(2, 10);
    for (int k = 0; k < count && !effort.stopped(); ++k) {
        const TracedPath path = timed_six_bar(k);
        const Problem problem = parse_problem(path.text, "path.toml").problem;
        const Program program = build_program(problem, variants(problem).front());
        const BoxedError error = error_of(program, path.size / program.length);
        double least = worth_nothing;
        seconds.push_back(
            timed_on_this_thread([&] { least = peer.least(error, static_cast<std::uint64_t>(k), most); }, 1).median);
        errors.push_back(least);
        met += least <= met_to;
    }
    return {row_of(peer.name.data(), usual_points, timing_of(seconds), static_cast<double>(most), met, count,
                   timing_of(errors).median)};
}

std::vector<Measurement> synthesis_measurements(const Effort&) {
    std::vector<Measurement> all{{"cold starts", cold_starts}};
    for (const int links : {4, 6, 8, 10, 12}) {
        all.push_back({fmt::format("program of {} links", links), [links](const Effort& e) {
                           return evaluations(e, traced_chain(0, links, usual_points, true), links, over_links);
                       }});
        all.push_back({fmt::format("solution of {} links", links), [links](const Effort& e) {
                           return solutions(e, solved_over_links, links, [links](int k) {
                               return traced_chain(static_cast<std::uint64_t>(k), links, usual_points);
                           });
                       }});
    }
    for (const int points : {6, 12, 24, 48, 96}) {
        const auto path_of = [points](int k) {
            return traced_six_bar(static_cast<std::uint64_t>(k), true, points, true);
        };
        all.push_back({fmt::format("program of {} points", points),
                       [points, path_of](const Effort& e) { return evaluations(e, path_of(0), points, over_points); }});
        all.push_back({fmt::format("solution of {} points", points), [points, path_of](const Effort& e) {
                           return solutions(e, solved_over_points, points, path_of);
                       }});
    }
    all.push_back({ours, [](const Effort& e) { return solutions(e, ours, usual_points, timed_six_bar); }});
    for (const PeerOfLinkages& peer : peers_of_linkages())
        for (const long most : evaluations_of_peers)
            all.push_back({fmt::format("{}, {} evaluations", peer.name, most),
                           [&peer, most](const Effort& e) { return by_peer(e, peer, most); }});
    return all;
}

std::vector<std::pair<double, double>> points_of_series(const Sheet& sheet, const char* series) {
    std::vector<std::pair<double, double>> points;
    for (const Row& row : sheet.where("series", series))
        points.emplace_back(sheet.number(row, "size"), sheet.number(row, "seconds"));
    return points;
}

std::string of_all(double part, double all) { return fmt::format("{:.0f} of {:.0f}", part, all); }

/// "A six-bar ... takes 0.9 s in the median (0.8 s of the processor), and 40 of 40 are met."
std::string cold_text(const Sheet& sheet) {
    const auto wall = sheet.where("series", cold), processor = sheet.where("series", cold_processor);
    if (wall.empty() || processor.empty()) return "";
    const double seconds = sheet.number(wall[0], "seconds");
    return fmt::format(
        "From the start of the program to a verified design a six-bar of {} timed points takes {} in the median, {} of "
        "the processor, {} the second that is aimed at; {} are met.\n\n",
        usual_points, time_text(seconds), time_text(sheet.number(processor[0], "seconds")),
        seconds < 1 ? "within" : "beyond", of_all(sheet.number(wall[0], "met"), sheet.number(wall[0], "of")));
}

/// How many times a value a gradient costs at most.
double greatest_ratio(const Sheet& sheet, const char* const (&series)[2]) {
    const auto value = points_of_series(sheet, series[0]), gradient = points_of_series(sheet, series[1]);
    double greatest = 0;
    for (std::size_t i = 0; i < std::min(value.size(), gradient.size()); ++i)
        greatest = std::max(greatest, gradient[i].second / value[i].second);
    return greatest;
}

MarkdownTable growth(const Sheet& sheet) {
    MarkdownTable table{{"time of", "from", "to", "grows with the power", "met"}, {}};
    for (const char* series :
         {over_links[0], over_links[1], solved_over_links, over_points[0], over_points[1], solved_over_points}) {
        const auto points = points_of_series(sheet, series);
        if (points.size() < 2) continue;
        double met = 0, of = 0;
        for (const Row& row : sheet.where("series", series)) {
            met += sheet.number(row, "met");
            of += sheet.number(row, "of");
        }
        const auto at = [](const std::pair<double, double>& p) {
            return fmt::format("{}: {}", whole_number(p.first), time_text(p.second));
        };
        table.rows.push_back({series, at(points.front()), at(points.back()),
                              significant(fitted_power(points).exponent, 2), of > 0 ? of_all(met, of) : ""});
    }
    return table;
}

MarkdownTable side_by_side(const Sheet& sheet) {
    MarkdownTable table{{"search", "met", "error, parts of the path's size", "evaluations", "processor"}, {}};
    for (const std::string& series : sheet.distinct("series"))
        for (const Row& row : sheet.where("series", series)) {
            const bool is_peer = std::any_of(peers_of_linkages().begin(), peers_of_linkages().end(),
                                             [&](const PeerOfLinkages& peer) { return peer.name == series; });
            if (series != ours && !is_peer) continue;
            table.rows.push_back({series, of_all(sheet.number(row, "met"), sheet.number(row, "of")),
                                  significant(sheet.number(row, "error")),
                                  whole_number(sheet.number(row, "evaluations")),
                                  time_text(sheet.number(row, "seconds"))});
        }
    return table;
}

std::string synthesis_chapter(const Sheet& sheet) {
    const double ratio = std::max(greatest_ratio(sheet, over_links), greatest_ratio(sheet, over_points));
    return "Linkages that files describe, found again from timed points of the paths of random ones, with every "
           "dimension "
           "and the placement to be found. Longer chains are a four-bar and dyads that hang one on the other. Medians; "
           "times of programs and solutions are of the processor, on one core.\n\n" +
           cold_text(sheet) +
           fmt::format("Value and gradient of a program take at most {} times the value, {} the four aimed at.\n\n",
                       significant(ratio, 2), ratio <= 4 ? "within" : "beyond") +
           to_markdown(growth(sheet)) +
           "\nThe same six-bars by others, which see no derivatives: particle swarms as pylinkage has them by default, "
           "and "
           "differential evolution. Evaluations of our own search are the candidates drawn and those of local "
           "searches.\n\n" +
           to_markdown(side_by_side(sheet));
}

std::vector<Diagram> synthesis_diagrams(const Sheet& sheet) {
    Diagram d;
    d.name = "linkage-synthesis-growth";
    d.title = "Time over links and points";
    d.x = "links, points";
    d.y = "s";
    d.log_x = d.log_y = true;
    for (const char* series : {over_links[1], solved_over_links, over_points[1], solved_over_points})
        d.curves.push_back({series, points_of_series(sheet, series)});
    return {d};
}

}  // namespace

Section linkage_synthesis() {
    return {"linkage-synthesis",
            "Linkages that files describe, found from their paths",
            {"measurement", "series", "size", "seconds", "lower", "upper", "evaluations", "met", "of", "error"},
            synthesis_measurements,
            synthesis_chapter,
            synthesis_diagrams};
}

}  // namespace mechwright::bench
