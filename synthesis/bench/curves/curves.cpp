#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/bench/curves/best_known.h"
#include "synthesis/bench/curves/campaign.h"
#include "synthesis/bench/curves/shapes.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/timing.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"

namespace mechwright::bench {

namespace {

/// A run came to the best known design within such a part of its error.
constexpr double reached_within = 1e-6;
constexpr double nearly_within = 1e-3;
/// What writing points with four decimals (problem_text) moves them by: the root of the mean square of two evenly
/// spread roundings, in mm. Designs that miss points by no more tell rounding from rounding, not shapes.
constexpr double rounding_of_points = 4.1e-5;

std::vector<Row> measured(const Shape& shape, const Effort& effort) {
    std::vector<Row> rows;
    RunOptions options;
    options.jobs = effort.jobs;
    options.stop = effort.stop;
    for (int seed = 1; seed <= effort.pick(1, 5) && !effort.stopped(); ++seed) {
        const Problem problem = parse_problem(problem_text(shape, seed), "shape.toml").problem;
        const Result result = solve(problem, options);
        const Cell error = result.status == Status::solved ? Cell(result.best->objective) : Cell();
        rows.push_back({seed, error, result.search.missed_chance, static_cast<double>(result.search.evaluations),
                        result.search.seconds});
    }
    return rows;
}

std::vector<Measurement> curves_measurements(const Effort& effort) {
    std::vector<Measurement> all;
    const std::vector<Shape> every = shapes();
    const std::size_t step = effort.pick<std::size_t>(12, 1);
    for (std::size_t i = 0; i < every.size(); i += step)
        all.push_back({every[i].name, [shape = every[i]](const Effort& e) { return measured(shape, e); }});
    return all;
}

struct Tally {
    double runs = 0;
    double hits = 0;
    double estimate = 0;  ///< sum of the chances that were told

    std::string share() const { return share_text(hits, runs); }
};

std::string success_table(const Sheet& sheet) {
    Tally reached, as_written, nearly;
    std::vector<double> seconds, evaluations;
    std::string better;
    for (const std::string& shape : sheet.distinct("shape")) {
        const double least = least_error(sheet, shape);
        for (const BestKnown& known : best_known())
            if (known.shape == shape && least < (1 - reached_within) * known.rms)
                better += fmt::format("\n- {}: {:.9g} mm instead of {:.9g} mm\n", shape, least, known.rms);
        for (const Row& row : sheet.where("shape", shape)) {
            const double error = sheet.number(row, "path-rms");
            reached.runs += 1;
            as_written.runs += 1;
            nearly.runs += 1;
            reached.hits += error <= (1 + reached_within) * least;
            as_written.hits += error <= std::max((1 + reached_within) * least, rounding_of_points);
            nearly.hits += error <= (1 + nearly_within) * least;
            seconds.push_back(sheet.number(row, "seconds"));
            evaluations.push_back(sheet.number(row, "evaluations"));
        }
    }
    if (seconds.empty()) return "";
    MarkdownTable table{{"shapes", "runs", "within 1e-6 of the best known", "or of what points are rounded by",
                         "within 1e-3", "median time", "95 % of times below", "median evaluations"},
                        {}};
    table.rows.push_back({fmt::format("{}", sheet.distinct("shape").size()), fmt::format("{:.0f}", reached.runs),
                          reached.share(), as_written.share(), nearly.share(), time_text(quantile(seconds, 0.5)),
                          time_text(quantile(seconds, 0.95)), fmt::format("{:.0f}", quantile(evaluations, 0.5))});
    const std::string found = better.empty() ? "" : "\nBetter than the best known until now:\n" + better;
    return to_markdown(table) + found;
}

/// Of runs that told chances of a size, how many were missing a better design.
std::string calibration_table(const Sheet& sheet) {
    constexpr std::array limits{0.0, 0.02, 0.05, 0.1, 0.2, 1.0};
    std::array<Tally, limits.size()> tallies;
    for (const std::string& shape : sheet.distinct("shape"))
        for (const Row& row : sheet.where("shape", shape)) {
            const double told = sheet.number(row, "missed");
            const auto at = std::lower_bound(limits.begin(), limits.end(), told) - limits.begin();
            Tally& tally = tallies[static_cast<std::size_t>(std::min<std::ptrdiff_t>(at, limits.size() - 1))];
            tally.runs += 1;
            tally.estimate += told;
            tally.hits += !(sheet.number(row, "path-rms") <= (1 + reached_within) * least_error(sheet, shape));
        }
    MarkdownTable table{{"told chance that a better one was missed", "runs", "told on average", "missed one"}, {}};
    for (std::size_t i = 0; i < limits.size(); ++i)
        if (tallies[i].runs > 0)
            table.rows.push_back(
                {i == 0 ? "0" : fmt::format("{:.0f} to {:.0f} %", 100 * limits[i - 1], 100 * limits[i]),
                 fmt::format("{:.0f}", tallies[i].runs),
                 fmt::format("{:.1f} %", 100 * tallies[i].estimate / tallies[i].runs), tallies[i].share()});
    return to_markdown(table);
}

std::string curves_chapter(const Sheet& sheet) {
    return "Letters, hearts, feet, airfoils, loops, noisy ovals, in any order, by four-bars whose every dimension is "
           "to "
           "be\nfound; some with limits of length, of the transmission angle, of the ratio of links. The best known "
           "designs were\nfound by many seeds. Points are written with four decimals, which moves them by 4.1e-5 mm "
           "(root mean\nsquare): letters C and V, the right angle and the straight line are met better than that, and "
           "which design is\nthe best of them is chance; a column counts these as reached. Default options, cold, all "
           "threads.\n\n" +
           success_table(sheet) + "\n" + calibration_table(sheet);
}

std::vector<Diagram> curves_diagrams(const Sheet&) { return {}; }

}  // namespace

Section curves() {
    return {"curves",
            "Shapes that no linkage draws",
            {"shape", "seed", "path-rms", "missed", "evaluations", "seconds"},
            curves_measurements,
            curves_chapter,
            curves_diagrams};
}

}  // namespace mechwright::bench
