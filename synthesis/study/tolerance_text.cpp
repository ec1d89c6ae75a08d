#include "synthesis/study/tolerance_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/report/text/table.h"
#include "synthesis/study/allocation.h"

namespace mechwright {

namespace {

std::string named(const QuantitySpread& spread) {
    return spread.unit.empty() ? spread.quantity : spread.quantity + ", " + spread.unit;
}

std::string spreads(const ToleranceReport& report) {
    Table table{{Align::left, Align::right, Align::right, Align::right, Align::right, Align::right, Align::right},
                {{"", "nominal", "s", "predicted", "2.5%", "97.5%", "worst"}}};
    for (const QuantitySpread& s : report.quantities)
        table.rows.push_back({named(s), number_text(s.nominal, 5), number_text(s.deviation, 3),
                              s.first_order ? number_text(*s.first_order, 3) : "", number_text(s.low, 6),
                              number_text(s.high, 6), s.first_order ? "+- " + number_text(s.worst, 3) : ""});
    return to_text(table, 2);
}

/// One row for each quantity with derivatives, one column for each dimension.
template <class CellText>
std::string by_dimension(const ToleranceReport& report, const CellText& cell) {
    Table table{{Align::left}, {{""}}};
    for (const std::string& dimension : report.dimensions) {
        table.columns.push_back(Align::right);
        table.rows.front().push_back(dimension);
    }
    for (const QuantitySpread& s : report.quantities) {
        if (s.derivatives.empty()) continue;
        std::vector<std::string> row{named(s)};
        for (std::size_t i = 0; i < s.derivatives.size(); ++i)
            row.push_back(cell(s, i));
        table.rows.push_back(std::move(row));
    }
    return to_text(table, 2);
}

/// What a deviation is called: its distribution and size, of a clearance all of it.
std::string deviation_text(const ToleranceReport& report, std::size_t i, double size) {
    if (report.clearances[i]) return number_text(2 * size, 3);
    return report.uniform[i] ? "+- " + number_text(size, 3) : "s = " + number_text(size, 3);
}

std::string allocation_text(const ToleranceReport& report, const AllocatedTolerances& allocated) {
    Table table{{Align::left, Align::left, Align::left, Align::right, Align::left},
                {{"", "usual", "allocated", "times", "fits"}}};
    bool unlimited = false;
    for (std::size_t i = 0; i < report.dimensions.size(); ++i) {
        const double usual = report.sizes[i] / allocated.times[i];
        const bool widest = allocated.times[i] >= widest_times;
        unlimited |= widest;
        table.rows.push_back({report.dimensions[i], deviation_text(report, i, usual),
                              deviation_text(report, i, report.sizes[i]),
                              number_text(allocated.times[i], 3) + (widest ? " *" : ""),
                              report.grades[i] > 0 ? fmt::format("IT{}", report.grades[i]) : ""});
    }
    std::string text =
        fmt::format("\nTolerances allocated so that {:.6g}% of pieces meet all limits\n", 100 * report.wanted_share) +
        to_text(table, 2);
    if (unlimited) text += fmt::format("  * no limit asks for less than {} times the usual one\n", widest_times);
    text +=
        fmt::format("  They cost {} of what the usual ones do.", number_text(allocated.cost / allocated.usual_cost, 3));
    if (!allocated.limits.empty()) text += " What keeps them from being wider:";
    text += '\n';
    for (const std::string& limit : allocated.limits)
        text += "  " + limit + "\n";
    return text;
}

}  // namespace

std::string tolerance_text(const ToleranceReport& report) {
    std::string text = fmt::format("{} samples, {} assemble", report.samples, report.assembled);
    if (report.has_limits)
        text += fmt::format(", {} ({:.2f}%) within all limits", report.within_limits,
                            100.0 * static_cast<double>(report.within_limits) / static_cast<double>(report.samples));
    text += '\n';
    if (report.allocated) text += allocation_text(report, *report.allocated);
    text +=
        "\nSpread (s: standard deviation of the samples; predicted: from the derivatives;\nworst: with all zones at "
        "their ends)\n" +
        spreads(report);
    const bool pins = std::find(report.clearances.begin(), report.clearances.end(), true) != report.clearances.end();
    text +=
        fmt::format("\nChange per unit of each dimension{}\n",
                    pins ? ", and per unit by which a pin is off in the worst direction" : "") +
        by_dimension(report, [](const QuantitySpread& s, std::size_t i) { return number_text(s.derivatives[i], 4); });
    text += "\nPart of the variance that comes from each dimension\n" +
            by_dimension(report, [](const QuantitySpread& s, std::size_t i) {
                return fmt::format("{:.0f}%", 100 * s.parts[i]);
            });
    return text;
}

}  // namespace mechwright
