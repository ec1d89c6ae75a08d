#include "synthesis/study/tolerance_text.h"

#include <fmt/format.h>

#include "synthesis/report/table.h"

namespace mechwright {

namespace {

constexpr int digits = 6;

std::string named(const QuantitySpread& spread) {
    return spread.unit.empty() ? spread.quantity : spread.quantity + ", " + spread.unit;
}

std::string spreads(const ToleranceReport& report) {
    Table table{{Align::left, Align::right, Align::right, Align::right, Align::right, Align::right},
                {{"", "nominal", "mean", "s", "s, 1st order", "95 % within"}}};
    for (const QuantitySpread& s : report.quantities)
        table.rows.push_back({named(s), number_text(s.nominal, digits), number_text(s.mean, digits),
                              number_text(s.deviation, 4), s.first_order ? number_text(*s.first_order, 4) : "",
                              number_text(s.low, digits) + " ... " + number_text(s.high, digits)});
    return to_text(table, 2);
}

/// The derivative of each quantity with respect to each dimension, and the part of the variance that comes from it.
std::string origins(const ToleranceReport& report) {
    Table table{{Align::left}, {{""}}};
    for (const std::string& dimension : report.dimensions) {
        table.columns.push_back(Align::right);
        table.rows.front().push_back(dimension);
    }
    for (const QuantitySpread& s : report.quantities) {
        if (s.derivatives.empty()) continue;
        std::vector<std::string> row{named(s)};
        for (std::size_t i = 0; i < s.derivatives.size(); ++i)
            row.push_back(fmt::format("{} ({:.0f}%)", number_text(s.derivatives[i], 4), 100 * s.parts[i]));
        table.rows.push_back(std::move(row));
    }
    return to_text(table, 2);
}

}  // namespace

std::string tolerance_text(const ToleranceReport& report) {
    std::string text = fmt::format("{} samples, {} assemble", report.samples, report.assembled);
    if (report.has_limits)
        text += fmt::format(", {} ({:.2f}%) within all limits", report.within_limits,
                            100.0 * static_cast<double>(report.within_limits) / static_cast<double>(report.samples));
    text += "\n\nSpread (s: standard deviation)\n" + spreads(report);
    text += "\nChange per unit of each dimension (and its part of the variance)\n" + origins(report);
    return text;
}

}  // namespace mechwright
