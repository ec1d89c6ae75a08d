#include <fmt/format.h>

#include <algorithm>

#include "synthesis/bench/digits.h"
#include "synthesis/bench/extremes/cases.h"
#include "synthesis/bench/fitted_power.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/timing.h"

namespace mechwright::bench {

namespace {

constexpr std::array sample_counts{36, 90, 360, 720, 3600, 36000};
constexpr const char* sampled_way = "sampled";
constexpr const char* exact_way = "exact";

/// The greatest relative error over the mechanisms.
template <class Function>
double worst_error(const ExtremeCase& c, const std::vector<Digits50>& reference, const Function& found) {
    double worst = 0;
    for (std::size_t k = 0; k < c.mechanisms; ++k)
        worst = std::max(worst, error_of(found(k), reference[k]) / std::abs(static_cast<double>(reference[k])));
    return worst;
}

std::vector<Row> measure(const ExtremeCase& c, const Effort& effort) {
    std::vector<Digits50> reference;
    for (std::size_t k = 0; k < c.mechanisms; ++k)
        reference.push_back(c.reference(k));
    std::vector<Piece> pieces;
    std::vector<Row> rows;
    for (const int samples : sample_counts) {
        const auto by_sampling = [c, samples](std::size_t k) { return c.sampled(k % c.mechanisms, samples); };
        pieces.push_back(piece(by_sampling));
        rows.push_back({sampled_way, samples, worst_error(c, reference, by_sampling)});
    }
    const auto exactly = [c](std::size_t k) { return c.exact(k % c.mechanisms); };
    pieces.push_back(piece(exactly));
    rows.push_back({exact_way, nullptr, worst_error(c, reference, exactly)});
    const auto timings = timed(pieces, effort.pick(5, 15), effort.pick(0.05, 0.5));
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (const double seconds : {timings[i].median, timings[i].lower, timings[i].upper})
            rows[i].push_back(seconds);
    return rows;
}

std::vector<Measurement> extremes_measurements(const Effort&) {
    std::vector<Measurement> all;
    for (auto cases : {linkage_extremes, cam_extremes})
        for (const ExtremeCase& c : cases())
            all.push_back({std::string(c.name), [c](const Effort& effort) { return measure(c, effort); }});
    return all;
}

/// How one extreme is found: exactly, and by more and more samples.
struct Found {
    struct At {
        double samples, error, seconds;
    };
    std::string name;
    At exactly{};
    std::vector<At> sampled;

    /// The error over the number of samples, and the time.
    Power error_by_samples() const {
        return fitted([](const At& at) { return std::pair(at.samples, at.error); });
    }
    Power seconds_by_samples() const {
        return fitted([](const At& at) { return std::pair(at.samples, at.seconds); });
    }
    /// The error of as many samples as take the time of the exact extreme.
    double error_at_equal_time() const { return error_by_samples()(seconds_by_samples().at(exactly.seconds)); }
    /// The time of as many samples as come so close, over that of the exact extreme.
    double ratio_at(double error) const { return seconds_by_samples()(error_by_samples().at(error)) / exactly.seconds; }

private:
    template <class Function>
    Power fitted(const Function& pair) const {
        std::vector<std::pair<double, double>> points;
        std::ranges::transform(sampled, std::back_inserter(points), pair);
        return fitted_power(points);
    }
};

std::vector<Found> all_found(const Sheet& sheet) {
    std::vector<Found> all;
    for (const std::string& name : sheet.distinct("extreme")) {
        Found found{name, {}, {}};
        for (const Row& row : sheet.where("extreme", name)) {
            const Found::At at{sheet.number(row, "samples"), sheet.number(row, "error"), sheet.number(row, "seconds")};
            if (sheet.text(row, "method") == exact_way)
                found.exactly = at;
            else
                found.sampled.push_back(at);
        }
        all.push_back(std::move(found));
    }
    return all;
}

/// A row for each extreme: the exact one, then a column for each number of samples.
template <class Exact, class Sampled>
MarkdownTable table(const std::vector<Found>& all, const char* what, const Exact& exact_cell,
                    const Sampled& sampled_cell) {
    MarkdownTable table{{what, exact_way}, {}};
    for (const int samples : sample_counts)
        table.head.push_back(std::to_string(samples));
    for (const Found& found : all) {
        std::vector<std::string> row{found.name, exact_cell(found.exactly)};
        for (const Found::At& at : found.sampled)
            row.push_back(sampled_cell(found, at));
        table.rows.push_back(std::move(row));
    }
    return table;
}

template <class Function>
std::string span_of(const std::vector<Found>& all, const Function& number) {
    std::vector<double> numbers;
    std::ranges::transform(all, std::back_inserter(numbers), number);
    const auto [least, greatest] = std::ranges::minmax(numbers);
    return significant(least, 2) + " to " + significant(greatest, 2);
}

std::string at_equal_time(const std::vector<Found>& slower) {
    if (slower.empty()) return {};
    return fmt::format(" Sampled for as long as the others take, these would be off by {}.",
                       span_of(slower, [](const Found& f) { return f.error_at_equal_time(); }));
}

std::string extremes_chapter(const Sheet& sheet) {
    constexpr double tolerance = 1e-9;  // that of a problem, unless it says another
    const auto all = all_found(sheet);
    std::vector<Found> slower;  // than the coarsest sampling
    std::ranges::copy_if(all, std::back_inserter(slower),
                         [](const Found& f) { return f.exactly.seconds >= f.sampled.front().seconds; });
    return "Extremes over a motion as the program finds them, and by so many samples of it (of a cam's whole turn, of "
           "a "
           "limited range). Relative errors, the greatest over the mechanisms of a kind, against fifty digits:\n\n" +
           to_markdown(table(
               all, "error", [](const Found::At& at) { return significant(at.error, 2); },
               [](const Found&, const Found::At& at) { return significant(at.error, 2); })) +
           "\nTimes; those of samples in times of the exact extreme:\n\n" +
           to_markdown(table(
               all, "time", [](const Found::At& at) { return time_text(at.seconds); },
               [](const Found& f, const Found::At& at) { return ratio_text(at.seconds / f.exactly.seconds); })) +
           fmt::format(
               "\nA sampled extreme is never beyond the true one, so that its error always is to the unsafe side. It "
               "falls "
               "with the number of samples to the power {} (fitted). To come as close as {}, the tolerance of a "
               "problem, sampling would take {} times as long as the exact extreme. {} of {} exact extremes take less "
               "time than {} samples.{} The deviation from a line is a small difference of great lengths and shows "
               "their rounding. The smallest cam stands with the proof that it is the smallest, and with all its "
               "requirements evaluated.\n",
               span_of(all, [](const Found& f) { return f.error_by_samples().exponent; }), tolerance,
               span_of(all, [&](const Found& f) { return f.ratio_at(tolerance); }), all.size() - slower.size(),
               all.size(), sample_counts.front(), at_equal_time(slower));
}

std::vector<Diagram> extremes_diagrams(const Sheet& sheet) {
    Diagram d;
    d.name = "extremes";
    d.title = "Extremes over the motion: error over time";
    d.x = "s";
    d.y = "relative error";
    d.log_x = d.log_y = true;
    const auto all = all_found(sheet);
    for (const Found& found : all) {
        Curve curve{found.name, {}};
        for (const Found::At& at : found.sampled)
            curve.points.emplace_back(at.seconds, at.error);
        d.curves.push_back(std::move(curve));
    }
    for (std::size_t i = 0; i < all.size(); ++i)
        d.curves.push_back({"exact: " + all[i].name, {{all[i].exactly.seconds, all[i].exactly.error}}, i});
    return {d};
}

}  // namespace

Section extremes() {
    return {"extremes",
            "Extremes over the motion: exact against sampled",
            {"extreme", "method", "samples", "error", "seconds", "lower", "upper"},
            extremes_measurements,
            extremes_chapter,
            extremes_diagrams};
}

}  // namespace mechwright::bench
