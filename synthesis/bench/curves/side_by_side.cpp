#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/bench/curves/campaign.h"
#include "synthesis/bench/curves/peer_methods.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/timing.h"

namespace mechwright::bench {

namespace {

/// Every so manieth shape of those without requirements, and the evaluations of a run.
constexpr std::size_t step = 4;
constexpr long evaluations = 200'000;

std::vector<Row> measured(const Shape& shape, const Effort& effort) {
    std::vector<Row> rows;
    for (const PeerMethod& method : peer_methods())
        for (int seed = 1; seed <= effort.pick(1, 2) && !effort.stopped(); ++seed) {
            if (method.closed_only && !shape.closed) continue;
            const PeerRun run = method.run(shape, static_cast<std::uint64_t>(seed), effort.pick(20'000L, evaluations));
            rows.push_back({std::string(method.name), seed, std::isfinite(run.rms) ? Cell(run.rms) : Cell(),
                            run.evaluations, run.seconds});
        }
    return rows;
}

std::vector<Measurement> side_by_side_measurements(const Effort& effort) {
    std::vector<Measurement> all;
    std::vector<Shape> without_requirements = shapes();
    std::erase_if(without_requirements, [](const Shape& s) { return !s.requirement.empty() || s.longest != 200; });
    for (std::size_t i = 0; i < without_requirements.size(); i += effort.pick<std::size_t>(100, step))
        all.push_back({without_requirements[i].name,
                       [shape = without_requirements[i]](const Effort& e) { return measured(shape, e); }});
    return all;
}

std::string side_by_side_chapter(const Sheet& sheet) {
    MarkdownTable table{{"method", "runs", "within 1e-6 of the best known", "within 1e-3", "within 10 %",
                         "median error", "median evaluations", "median time", "95 % of times below"},
                        {}};
    for (const std::string& method : sheet.distinct("method")) {
        double runs = 0, close = 0, near = 0, usable = 0;
        std::vector<double> times, counts, errors;
        for (const Row& row : sheet.where("method", method)) {
            const double least = least_error(sheet, sheet.text(row, "shape"));
            const double found = sheet.number(row, "path-rms");
            const double error = std::isnan(found) ? std::numeric_limits<double>::infinity() : found / least;
            ++runs;
            close += error <= 1 + 1e-6;
            near += error <= 1 + 1e-3;
            usable += error <= 1.1;
            errors.push_back(error);
            times.push_back(sheet.number(row, "seconds"));
            counts.push_back(sheet.number(row, "evaluations"));
        }
        table.rows.push_back({method, fmt::format("{:.0f}", runs), share_text(close, runs), share_text(near, runs),
                              share_text(usable, runs), fmt::format("{:.3g} x", quantile(errors, 0.5)),
                              fmt::format("{:.0f}", quantile(counts, 0.5)), time_text(quantile(times, 0.5)),
                              time_text(quantile(times, 0.95))});
    }
    return "The same shapes without requirements by searches that others use, on one thread each. CMA-ES and "
           "differential\nevolution are pagmo's (2.18, Debian), on the program's own measure of a whole curve, begun "
           "again until 200,000\nevaluations are used up; differential evolution on elliptic Fourier descriptors "
           "follows four-bar-rs (200 individuals,\n50 generations, for closed shapes), whatever size of links it comes "
           "to. Median error: times the best known.\n\n" +
           to_markdown(table);
}

std::vector<Diagram> side_by_side_diagrams(const Sheet&) { return {}; }

}  // namespace

Section curve_peers() {
    return {"curve-peers",
            "Shapes that no linkage draws, side by side",
            {"shape", "method", "seed", "path-rms", "evaluations", "seconds"},
            side_by_side_measurements,
            side_by_side_chapter,
            side_by_side_diagrams};
}

}  // namespace mechwright::bench
