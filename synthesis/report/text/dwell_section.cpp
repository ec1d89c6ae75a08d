#include "synthesis/report/text/dwell_section.h"

#include <fmt/format.h>

#include "synthesis/mechanism/input.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/alternation/dwell_alternation.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

/// What the number of extremes says.
std::string words_of(const DwellAlternation& dwell) {
    std::string text = fmt::format(
        "{} extremes are as far from the middle as the farthest and alternate, for {} free number{} (the middle is "
        "one), "
        "{} of which limits hold",
        dwell.alternating, dwell.free, dwell.free == 1 ? "" : "s", dwell.held == 0 ? "none" : number_text(dwell.held));
    const int needed = dwell.free - dwell.held + 1;
    if (dwell.balanced) return text + ": to first order no design near this one is as still.";
    if (dwell.alternating < needed)
        return text + fmt::format(". It would take {} to show that no design near this one is stiller.", needed);
    return text + ". They do not show whether a design near this one is stiller.";
}

}  // namespace

std::string dwell_section(const Problem& problem, const Design& design, const TextStyle& style) {
    std::string text;
    for (const DwellAlternation& dwell : dwell_alternations(problem, design)) {
        const Unit unit = dwell.quantity->unit;
        const auto value = [&](double of) { return quantity_with_unit(of, unit, problem, design, style.digits); };
        Table table{{Align::left, Align::point, Align::left, Align::point}, {}};
        for (const DwellExtreme& e : dwell.extremes) {
            const double input = in_file_unit(e.input, input_unit(*problem.mechanism), problem.units);
            table.rows.push_back({fmt::format("at {}", input_word(*problem.mechanism)),
                                  rounded_text(input, style.digits), "is off by", value(e.value - dwell.middle)});
        }
        text += heading(fmt::format("Dwell: {} about {}", dwell.quantity->name, value(dwell.middle)), style);
        text += to_text(table, 2) + folded("  ", words_of(dwell));
    }
    return text;
}

}  // namespace mechwright
