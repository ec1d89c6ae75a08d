#include "synthesis/bench/kernels/chapter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/bench/kernels/lanes.h"
#include "synthesis/bench/kernels/measured_kernel.h"
#include "synthesis/bench/kernels/screening.h"
#include "synthesis/bench/pages/markdown.h"

namespace mechwright::bench {

namespace {

const Row* find(const Sheet& sheet, const std::string& kernel, std::string_view order, std::string_view form) {
    for (const Row& row : sheet.rows)
        if (sheet.text(row, "kernel") == kernel && sheet.text(row, "order") == order && sheet.text(row, "form") == form)
            return &row;
    return nullptr;
}

std::string digits_text(const Sheet& sheet, const Row* row, std::string_view of) {
    if (row == nullptr) return {};
    const double median = sheet.number(*row, fmt::format("digits {} median", of));
    if (std::isnan(median)) return {};
    return fmt::format("{:.1f} ({:.1f})", median, sheet.number(*row, fmt::format("digits {} least", of)));
}

std::vector<std::string> single_kernels(const Sheet& sheet) {
    std::vector<std::string> names = sheet.distinct("kernel");
    std::erase(names, lanes_name);
    std::erase(names, screening_name);
    return names;
}

std::string instructions_text(const Sheet& sheet, const Row& row) {
    const double count = sheet.number(row, "instructions");
    return std::isnan(count) ? "" : fmt::format("{:.0f}", count);
}

/// The textbook's formulas against ours, in time and digits.
std::string against_textbook(const Sheet& sheet) {
    MarkdownTable table{{"kernel", "order", "textbook", "ours", "ratio", "instructions", "digits: textbook, usual",
                         "ours, usual", "textbook, hard", "ours, hard"},
                        {}};
    double least_ours = 17, least_textbook = 17;
    for (const std::string& kernel : single_kernels(sheet))
        for (const Row& ours : sheet.where("kernel", kernel)) {
            if (sheet.text(ours, "form") != form::ours) continue;
            const std::string order = sheet.text(ours, "order");
            const Row* textbook = find(sheet, kernel, order, form::textbook);
            if (textbook == nullptr) continue;
            const double old_ns = sheet.number(*textbook, "ns"), ns = sheet.number(ours, "ns");
            least_ours = std::min(least_ours, sheet.number(ours, "digits hard least"));
            least_textbook = std::min(least_textbook, sheet.number(*textbook, "digits hard least"));
            table.rows.push_back(
                {kernel, order, time_text(1e-9 * old_ns), time_text(1e-9 * ns), ratio_text(old_ns / ns),
                 fmt::format("{} : {}", instructions_text(sheet, *textbook), instructions_text(sheet, ours)),
                 digits_text(sheet, textbook, "usual"), digits_text(sheet, &ours, "usual"),
                 digits_text(sheet, textbook, "hard"), digits_text(sheet, &ours, "hard")});
        }
    return fmt::format(
               "Textbook formulas (arc cosines, differences of squares, angles handed on) against ours, one call after "
               "another\non 256 usual mechanisms; gradients of the textbook are central differences. Digits are "
               "correct "
               "decimal digits\nagainst the same formulas in fifty digits, which `tests/hard_cases` checks against "
               "another program's: the median,\nand in brackets the least. Where it is hard, the textbook comes down "
               "to "
               "{:.1f} digits, ours to {:.1f}.\n\n",
               least_textbook, least_ours) +
           to_markdown(table);
}

std::string hard_sets() {
    std::string text = "\nHard are, for k from 10 to 40:\n\n";
    const auto add = [&](std::string_view name, std::string_view hard) {
        text += fmt::format("- {}: {}\n", name, hard);
    };
    add(CouplerPointKernel::name, CouplerPointKernel::hard);
    add(SliderCrankKernel::name, SliderCrankKernel::hard);
    add(CrankShaperKernel::name, CrankShaperKernel::hard);
    add(RollerKernel::name, RollerKernel::hard);
    return text;
}

/// What is paid for each order, and saved by not asking for it.
std::string what_orders_cost(const Sheet& sheet) {
    MarkdownTable table{{"kernel", "order 0", "order 1", "order 2", "gradient", "Hessian", "fifty digits, order 0"},
                        {}};
    for (const std::string& kernel : single_kernels(sheet)) {
        const std::vector<Row> rows = sheet.where("kernel", kernel);
        std::vector<double> ours;
        double fifty = std::nan("");
        for (const Row& row : rows) {
            if (sheet.text(row, "form") == form::ours) ours.push_back(sheet.number(row, "ns"));
            if (sheet.text(row, "form") == form::fifty && std::isnan(fifty)) fifty = sheet.number(row, "ns");
        }
        std::vector<std::string> cells{kernel};
        for (std::size_t i = 0; i < ours.size(); ++i)
            cells.push_back(i == 0 ? time_text(1e-9 * ours[0])
                                   : fmt::format("{} ({})", time_text(1e-9 * ours[i]), ratio_text(ours[i] / ours[0])));
        cells.push_back(fmt::format("{} ({})", time_text(1e-9 * fifty), ratio_text(fifty / ours[0])));
        table.rows.push_back(std::move(cells));
    }
    return "\nWhat each order costs, in times of order 0; what is not asked for is not computed. Derivatives are by "
           "all "
           "dimensions\n(four-bar 6, slider-crank 3, crank shaper 5, cam 4).\n\n" +
           to_markdown(table);
}

/// The bounds by the mix of operations and by the number of instructions, and the distance from them.
std::string against_bound(const Sheet& sheet) {
    MarkdownTable table{{"kernel", "order", "sums and products", "quotients", "roots", "sines and cosines", "angles",
                         "instructions", "bound by operations", "by instructions", "time", "distance", "longest chain"},
                        {}};
    double farthest = 0;
    int rows = 0, within = 0;
    double least_of_chain = std::numeric_limits<double>::infinity(), most_of_chain = 0;  // of those that are farther
    for (const Row& row : sheet.rows) {
        const double by_operations = sheet.number(row, "ns by operations"), ns = sheet.number(row, "ns");
        if (std::isnan(by_operations)) continue;
        const double by_instructions = sheet.number(row, "ns by instructions");
        const double distance = ns / std::fmax(by_operations, by_instructions);
        const bool lanes = sheet.text(row, "kernel") == lanes_name;
        farthest = std::max(farthest, distance);
        ++rows;
        within += distance <= 2;
        const double chain = sheet.number(row, "ns of the longest chain");
        if (distance > 2) {
            least_of_chain = std::min(least_of_chain, ns / chain);
            most_of_chain = std::max(most_of_chain, ns / chain);
        }
        const auto count = [&](std::string_view of) { return fmt::format("{:.0f}", sheet.number(row, of)); };
        table.rows.push_back({lanes ? "four-bar, " + sheet.text(row, "form") : sheet.text(row, "kernel"),
                              sheet.text(row, "order"), count("sums and products"), count("quotients"), count("roots"),
                              count("sines and cosines"), count("angles"), instructions_text(sheet, row),
                              time_text(1e-9 * by_operations), time_text(1e-9 * by_instructions), time_text(1e-9 * ns),
                              ratio_text(distance), time_text(1e-9 * chain)});
    }
    return fmt::format(
               "\nWhat this processor allows. By operations: those that the result depends on, each once, are "
               "counted by a number type\nthat writes them down; sums and products, and quotients and roots, at "
               "the rate at which independent ones follow each\nother here (measured in the same run), the "
               "greater of the two sums; and what the C library takes for sines and arc\ntangents. By "
               "instructions: those that were executed, at the rate at which the processor takes in ones that do "
               "nothing.\nThe distance is from the greater of the two. Within a factor of two are {} of {}; the "
               "farthest is at {}.\nA result waits for the longest chain of operations of which each needs the one "
               "before, here by their latencies\n(shared among the lanes); a processor begins the next calls "
               "meanwhile, "
               "as far as it sees ahead.{}\n\n",
               within, rows, ratio_text(farthest),
               within == rows ? ""
                              : fmt::format(" Those that are\nfarther than a factor of two take {:.2f} to {:.2f} times "
                                            "their own chain.",
                                            least_of_chain, most_of_chain)) +
           to_markdown(table);
}

std::string lanes_paragraph(const Sheet& sheet) {
    const std::vector<Row> rows = sheet.where("kernel", lanes_name);
    if (rows.empty()) return {};
    MarkdownTable table{{"order", "how", "per linkage", "linkages a second", "ratio to one by one"}, {}};
    for (const Row& row : rows) {
        const Row* single = find(sheet, std::string(lanes_name), sheet.text(row, "order"), one_by_one_name);
        const double ns = sheet.number(row, "ns");
        table.rows.push_back({sheet.text(row, "order"), sheet.text(row, "form"), time_text(1e-9 * ns),
                              significant(1e9 / ns), ratio_text(sheet.number(*single, "ns") / ns)});
    }
    return "\nMany four-bars at one crank angle, as searches screen them. All ways give the same bits; the run ends "
           "with "
           "an error\nwhere they do not.\n\n" +
           to_markdown(table);
}

std::string screening_paragraph(const Sheet& sheet) {
    const std::vector<Row> rows = sheet.where("kernel", screening_name);
    if (rows.empty()) return {};
    const double narrowest = sheet.number(rows.front(), "ns");
    MarkdownTable table{{"how", "per candidate", "candidates a second", "ratio to the narrowest"}, {}};
    for (const Row& row : rows) {
        const double ns = sheet.number(row, "ns");
        table.rows.push_back(
            {sheet.text(row, "form"), time_text(1e-9 * ns), significant(1e9 / ns), ratio_text(narrowest / ns)});
    }
    return fmt::format("\nScreening: {}, each with its best placement, size and coupler point.\n\n", screening_name) +
           to_markdown(table);
}

}  // namespace

std::string kernel_chapter(const Sheet& sheet) {
    return against_textbook(sheet) + hard_sets() + what_orders_cost(sheet) + lanes_paragraph(sheet) +
           screening_paragraph(sheet) + against_bound(sheet);
}

std::vector<Diagram> kernel_diagrams(const Sheet& sheet) {
    Diagram diagram{"kernels",
                    "Digits kept in the hardest case against time",
                    "ns per call",
                    "correct digits",
                    true,
                    false,
                    Diagram::Joined::not_at_all,
                    {}};
    for (const std::string_view form : {form::textbook, form::ours}) {
        Curve curve{std::string(form), {}};
        for (const Row& row : sheet.rows)
            if (sheet.text(row, "form") == form)
                curve.points.emplace_back(sheet.number(row, "ns"), sheet.number(row, "digits hard least"));
        diagram.curves.push_back(std::move(curve));
    }
    return {diagram};
}

}  // namespace mechwright::bench
