// What others have published, or what was measured of their programs, beside ours in this run.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "synthesis/bench/kernels/lanes.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/shipped.h"
#include "synthesis/solve/solve.h"

namespace mechwright::bench {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A peer's result for a path that comes with mechwright.
struct PublishedPath {
    std::string_view problem;
    std::string_view peer;
    double error;        ///< the objective of our file: sum of squares, or root mean square
    double evaluations;  ///< as stated by the peer; NaN where it is not
    double seconds;      ///< on a machine of this kind, one thread; NaN where it was not run
};

// HCDJ: hybrid-combined differential evolution and Jaya, Symmetry 2022, 14(2), 381; individuals times iterations of its
// code, its vectors evaluated again. IOA, MUMSA, WYLin: rows of its tables. MKH: Bulatovic and others 2016.
// four-bar-rs 7.0.5: differential evolution, 200 individuals, 50 generations, curves of 180 points, one thread; the
// best of three runs on a machine like the one of the results in the source tree.
constexpr std::array published{
    PublishedPath{"path/case-1", "HCDJ", 8.84e-29, 100'000, unknown},
    PublishedPath{"path/case-2", "HCDJ", 1.92394e-6, 5'000, unknown},
    PublishedPath{"path/case-2", "MUMSA", 1.28400e-6, unknown, unknown},
    PublishedPath{"path/case-3", "HCDJ", 0.0160777, 5'000, unknown},
    PublishedPath{"path/case-3", "MKH", 0.00911498, unknown, unknown},
    PublishedPath{"path/case-5", "HCDJ", 4.2014e-4, 100'000, unknown},
    PublishedPath{"path/case-5", "WYLin", 4.01992e-4, unknown, unknown},
    PublishedPath{"path/yu1", "four-bar-rs", 0.389, unknown, 2.5},
    PublishedPath{"path/yu2", "four-bar-rs", 0.731, unknown, 2.5},
    PublishedPath{"path/mkh1", "four-bar-rs", 0.0142, unknown, 3.8},
    PublishedPath{"path/mcgarva", "four-bar-rs", 1.413, unknown, 1.7},
};

/// Coupler points a second of one thread.
struct PublishedRate {
    std::string_view peer;
    double points;
};
constexpr std::array rates{PublishedRate{"four-bar-rs 7.0.5 (Rust)", 7.4e6},
                           PublishedRate{"pylinkage 0.9 (Python, numba)", 0.38e6}};

Cell known(double number) { return std::isnan(number) ? Cell() : Cell(number); }

std::vector<Row> path_row(const PublishedPath& peer, const Effort& effort) {
    const auto problem = shipped_problem(effort.problems, peer.problem);
    if (!problem) return {};
    RunOptions options;
    options.stop = effort.stop;
    const Result result = solve(*problem, options);
    if (!result.best) return {};
    const auto& search = result.search;
    return {{std::string(peer.problem), std::string(peer.peer), peer.error, known(peer.evaluations),
             known(peer.seconds), result.best->objective, static_cast<double>(search.evaluations + search.drawn),
             search.seconds, Cell(), Cell(), Cell()}};
}

constexpr std::string_view points = "coupler points a second";

/// Ours: the quickest and the slowest way to take the points of many four-bars.
std::vector<Row> rate_rows(const Effort& effort) {
    const std::vector<Row> measured = measured_lanes(effort);
    double one_by_one = 0, lanes = 0;
    for (const Row& row : measured) {
        if (row[0] != "position") continue;
        const double rate = 1e9 / row[2].get<double>();
        if (row[1] == std::string(one_by_one_name)) one_by_one = rate;
        lanes = std::max(lanes, rate);
    }
    std::vector<Row> rows;
    for (const PublishedRate& peer : rates)
        rows.push_back({std::string(points), std::string(peer.peer), Cell(), Cell(), Cell(), Cell(), Cell(), Cell(),
                        peer.points, one_by_one, lanes});
    return rows;
}

std::vector<Measurement> peers_measurements(const Effort&) {
    std::vector<Measurement> all{{std::string(points), rate_rows}};
    for (const PublishedPath& peer : published)
        all.push_back({fmt::format("{} by {}", peer.problem, peer.peer),
                       [&peer](const Effort& effort) { return path_row(peer, effort); }});
    return all;
}

std::string rates_paragraph(const Sheet& sheet) {
    MarkdownTable table{
        {"coupler points a second, one thread", "theirs", "ours one by one", "ratio", "ours in lanes", "ratio"}, {}};
    for (const Row& row : sheet.where("of", points)) {
        const double theirs = sheet.number(row, "their rate"), single = sheet.number(row, "our rate one by one"),
                     lanes = sheet.number(row, "our rate in lanes");
        table.rows.push_back({sheet.text(row, "peer"), significant(theirs), significant(single),
                              ratio_text(single / theirs), significant(lanes), ratio_text(lanes / theirs)});
    }
    return to_markdown(table);
}

std::string number_or_dash(double number, const std::string& text) { return std::isnan(number) ? "-" : text; }

std::string paths_paragraph(const Sheet& sheet) {
    MarkdownTable table{{"path", "peer", "their error", "ours", "theirs over ours", "their evaluations", "ours",
                         "their time", "ours", "ratio of times"},
                        {}};
    int paths = 0, nearer = 0;
    for (const Row& row : sheet.rows) {
        if (sheet.text(row, "of") == points) continue;
        const double theirs = sheet.number(row, "their error"), ours = sheet.number(row, "our error");
        const double evaluations = sheet.number(row, "their evaluations"), seconds = sheet.number(row, "their seconds");
        const double our_seconds = sheet.number(row, "our seconds");
        ++paths;
        nearer += ours <= theirs * (1 + 1e-5);
        table.rows.push_back({sheet.text(row, "of"), sheet.text(row, "peer"), significant(theirs), significant(ours),
                              ratio_text(theirs / ours), number_or_dash(evaluations, significant(evaluations)),
                              significant(sheet.number(row, "our evaluations")),
                              number_or_dash(seconds, time_text(seconds)), time_text(our_seconds),
                              number_or_dash(seconds, ratio_text(seconds / our_seconds))});
    }
    return fmt::format(
               "\nPaths with default options, one thread, every candidate that was screened counted as an "
               "evaluation; errors are sums of\nsquares (cases) or root mean squares. Ours is as near or nearer "
               "(to the digits published) in {} of {}. Papers state\nevaluations and no times that could be "
               "compared; `-` is what is not known.\n\n",
               nearer, paths) +
           to_markdown(table);
}

std::string peers_chapter(const Sheet& sheet) {
    return "Figures of peers, as they were published or measured of their programs on a machine of the kind that the "
           "results in\nthe source tree are from (`synthesis/bench/peers.cpp` names the sources), and ours in this "
           "run.\n\n" +
           rates_paragraph(sheet) + paths_paragraph(sheet);
}

std::vector<Diagram> peers_diagrams(const Sheet&) { return {}; }

}  // namespace

Section peers() {
    return {"peers",
            "Peers",
            {"measurement", "of", "peer", "their error", "their evaluations", "their seconds", "our error",
             "our evaluations", "our seconds", "their rate", "our rate one by one", "our rate in lanes"},
            peers_measurements,
            peers_chapter,
            peers_diagrams};
}

}  // namespace mechwright::bench
