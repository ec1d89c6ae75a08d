#include <fmt/format.h>

#include <cmath>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/bench/exact/nine_points.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/timing.h"
#include "synthesis/exact/homotopy/certify.h"
#include "synthesis/exact/poses/dyads.h"

namespace mechwright::bench {

namespace {

using homotopy::TrackingOptions;

constexpr const char* all_paths = "paths";
constexpr const char* whole = "whole solution";
constexpr const char* dyads = "dyads of five poses";
constexpr const char* certificate = "certificate";

/// The time of what takes a second or so; a stop ends it soon.
template <class Call>
Timing timed_until_stopped(const Effort& effort, const Call& call) {
    return timed_on_this_thread(
        [&] {
            if (!effort.stopped()) call();
        },
        effort.pick(2, 9));
}

/// The row of a piece that has solutions and takes time, for so many of them.
Row timed_row(const char* piece, std::string_view way, Cell tolerance, double solutions, const Timing& t, Cell steps,
              Cell distinct) {
    return {piece,   std::string(way), std::move(tolerance), solutions,          t.median,
            t.lower, t.upper,          std::move(steps),     std::move(distinct)};
}

std::vector<Row> follow(const PathsBy& way, double tolerance, const Effort& effort) {
    const NinePoints points = nine_points();
    const TrackingOptions options = with_tolerance(tolerance);
    std::vector<homotopy::GuidancePath> paths;
    const Timing t = timed_until_stopped(effort, [&] { paths = way.follow(points, options); });
    const Ends ends = ends_of(points, paths);
    return {timed_row(all_paths, way.name, tolerance, nine_point_paths, t, ends.steps, ends.distinct)};
}

/// On one core, with all that makes every path accounted for.
std::vector<Row> solve_all(const Effort& effort) {
    const NinePoints points = nine_points();
    homotopy::GuidanceSolutions found;
    const Timing t =
        timed_until_stopped(effort, [&] { found = solve_guidance(*points.start, points.target.parameters, 1); });
    return {timed_row(whole, "", nullptr, nine_point_paths, t, nullptr, found.solutions.size())};
}

double random_number(std::uint64_t k, std::uint64_t i) {
    return std::ldexp(static_cast<double>(mixed(mixed(k) ^ i) >> 11) + 0.5, -53) - 0.5;
}

std::array<Displacement, 4> random_poses(std::uint64_t k) {
    std::array<Displacement, 4> poses;
    for (std::uint64_t i = 0; i < 4; ++i)
        poses[i] = {{3 * random_number(k, 3 * i), 3 * random_number(k, 3 * i + 1)},
                    std::polar(1.0, 6 * random_number(k, 3 * i + 2))};
    return poses;
}

std::vector<Row> find_dyads(const Effort& effort) {
    constexpr std::uint64_t problems = 1000;
    std::size_t found = 0;
    for (std::uint64_t k = 0; k < problems; ++k)
        found += dyads_through(random_poses(k)).dyads.size();
    const auto each = static_cast<double>(found) / problems;
    const Timing t =
        timed({piece([](std::size_t k) { return dyads_through(random_poses(k % problems)).dyads.size(); })},
              effort.pick(5, 15), effort.pick(0.2, 1.0))[0];
    return {timed_row(dyads, "", nullptr, each, t, nullptr, nullptr)};
}

/// The proof that one of the real solutions exists, in fifty digits.
std::vector<Row> prove(const Effort& effort) {
    const NinePoints points = nine_points();
    const auto found = solve_guidance(*points.start, points.target.parameters, 1).solutions;
    const auto real = std::ranges::find_if(found, homotopy::is_real);
    const auto parameters = exact_parameters(points.target, points.places);
    const auto proven = [&] { return certify(points.target.system, *real, parameters).has_value(); };
    const bool one = proven();
    const Timing t =
        timed({piece([&](std::size_t) { return proven(); })}, effort.pick(5, 15), effort.pick(0.2, 1.0))[0];
    return {timed_row(certificate, "", nullptr, 1, t, nullptr, one ? 1 : 0)};
}

std::vector<Measurement> exact_measurements(const Effort&) {
    std::vector<Measurement> all;
    const auto add = [&](const PathsBy& way, double tolerance) {
        all.push_back({fmt::format("{}, {:g}, {}", all_paths, tolerance, way.name),
                       [=](const Effort& effort) { return follow(way, tolerance, effort); }});
    };
    const auto ways = ways_to_follow();
    for (const PathsBy& way : ways)
        if (&way != &ways.back()) add(way, TrackingOptions{}.prediction_error);
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8})
        add(ways.back(), tolerance);
    all.push_back({whole, solve_all});
    all.push_back({dyads, find_dyads});
    all.push_back({certificate, prove});
    return all;
}

/// Seconds that one solution takes.
double each(const Sheet& sheet, const Row& row) {
    return sheet.number(row, "seconds") / sheet.number(row, "solutions");
}

/// Followed as the program follows them, and with the tolerance that it has.
struct Paths {
    std::vector<Row> by_way;        ///< with the program's tolerance, the slowest first
    std::vector<Row> by_tolerance;  ///< in the program's way
    Row usual;
};

std::optional<Paths> paths_of(const Sheet& sheet) {
    const auto rows = sheet.where("piece", all_paths);
    if (rows.empty()) return std::nullopt;
    Paths paths;
    const std::string way = sheet.text(rows.back(), "way");
    for (const Row& row : rows) {
        const bool usual = sheet.number(row, "tolerance") == TrackingOptions{}.prediction_error;
        if (usual) paths.by_way.push_back(row);
        if (sheet.text(row, "way") == way) paths.by_tolerance.push_back(row);
        if (usual && sheet.text(row, "way") == way) paths.usual = row;
    }
    if (paths.usual.empty()) return std::nullopt;
    return paths;
}

double missing(const Sheet& sheet, const Row& row) {
    return static_cast<double>(nine_point_paths) - sheet.number(row, "distinct");
}

std::string by_tolerance(const Sheet& sheet, const Paths& paths) {
    MarkdownTable table{{"tolerance", "paths per second", "over the program's", "steps each", "solutions missed"}, {}};
    for (const Row& row : paths.by_tolerance)
        table.rows.push_back({fmt::format("{:g}", sheet.number(row, "tolerance")), significant(1 / each(sheet, row)),
                              ratio_text(each(sheet, paths.usual) / each(sheet, row)),
                              significant(sheet.number(row, "steps")), whole_number(missing(sheet, row))});
    return to_markdown(table);
}

std::string by_way(const Sheet& sheet, const Paths& paths) {
    MarkdownTable table{{"paths", "per second", "over one by one", "solutions missed"}, {}};
    for (const Row& row : paths.by_way)
        table.rows.push_back({sheet.text(row, "way"), significant(1 / each(sheet, row)),
                              ratio_text(each(sheet, paths.by_way.front()) / each(sheet, row)),
                              whole_number(missing(sheet, row))});
    return to_markdown(table);
}

std::string of_all(const Sheet& sheet, const Paths& paths) {
    MarkdownTable table{{"for one solution", "time", "per second", "time over that of a path"}, {}};
    const auto add = [&](const std::string& name, const Row& row) {
        table.rows.push_back({name, time_text(each(sheet, row)), significant(1 / each(sheet, row)),
                              ratio_text(each(sheet, row) / each(sheet, paths.usual))});
    };
    add("path of nine points", paths.usual);
    for (const auto& [piece, name] :
         {std::pair(whole, "path with all that makes it accounted for"), std::pair(dyads, "dyad through five poses"),
          std::pair(certificate, "certificate in fifty digits")})
        for (const Row& row : sheet.where("piece", piece))
            add(name, row);
    return to_markdown(table);
}

std::string exact_chapter(const Sheet& sheet) {
    const auto paths = paths_of(sheet);
    if (!paths) return {};
    std::string text = fmt::format(
        "The {} paths to the four-bars through nine points (Problem 3 of Wampler, Morgan and Sommese) on one core, by "
        "the error that a step is allowed, relative. Solutions are missed where paths jump to others or end on the "
        "way:\n\n{}\nThe same with the program's tolerance, side by side in lanes and one by one:\n\n{}\n{}",
        nine_point_paths, by_tolerance(sheet, *paths), by_way(sheet, *paths), of_all(sheet, *paths));
    const Row* loosest = nullptr;
    for (const Row& row : paths->by_tolerance)
        if (missing(sheet, row) == 0 && (loosest == nullptr || each(sheet, row) < each(sheet, *loosest)))
            loosest = &row;
    text +=
        loosest == nullptr
            ? std::string("\nNone of these tolerances finds all solutions by following the paths alone.")
            : fmt::format("\nThe quickest of these tolerances with which following the paths alone finds all is {:g}.",
                          sheet.number(*loosest, "tolerance"));
    for (const Row& row : sheet.where("piece", whole))
        text += fmt::format(
            " The whole solution, which follows paths that jumped or stopped again, finds {} in {}: {} times the paths "
            "alone, which miss {}.\n",
            whole_number(sheet.number(row, "distinct")), time_text(sheet.number(row, "seconds")),
            significant(each(sheet, row) / each(sheet, paths->usual), 2), whole_number(missing(sheet, paths->usual)));
    return text;
}

std::vector<Diagram> exact_diagrams(const Sheet& sheet) {
    const auto paths = paths_of(sheet);
    if (!paths) return {};
    Diagram rate;
    rate.name = "exact-paths";
    rate.title = "Paths of nine points on one core";
    rate.x = "tolerance of a step";
    rate.y = "paths per second";
    rate.log_x = rate.log_y = true;
    Diagram missed = rate;
    missed.name = "exact-missed";
    missed.title = "Solutions of nine points that following the paths alone misses";
    missed.y = "solutions missed";
    missed.log_y = false;
    Curve per_second{"paths per second", {}}, misses{"missed", {}};
    for (const Row& row : paths->by_tolerance) {
        per_second.points.emplace_back(sheet.number(row, "tolerance"), 1 / each(sheet, row));
        misses.points.emplace_back(sheet.number(row, "tolerance"), missing(sheet, row));
    }
    rate.curves = {std::move(per_second)};
    missed.curves = {std::move(misses)};
    return {rate, missed};
}

}  // namespace

Section exact() {
    return {"exact",
            "Exact synthesis: paths, dyads, certificates",
            {"measurement", "piece", "way", "tolerance", "solutions", "seconds", "lower", "upper", "steps", "distinct"},
            exact_measurements,
            exact_chapter,
            exact_diagrams};
}

}  // namespace mechwright::bench
