#include "synthesis/report/text/error_sections.h"

#include <fmt/format.h>

#include "synthesis/program/error_extremes.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"
#include "synthesis/target/followed/text.h"
#include "synthesis/target/function/text.h"

namespace mechwright {

namespace {

/// One sentence, indented; empty where nothing alternates.
std::string alternation_text(const Problem& problem, const ErrorExtremes& extremes) {
    if (extremes.alternating < 2) return {};
    const bool least = extremes.free > 0 && extremes.alternating > extremes.free && asks_for_least_error(problem);
    return folded("  ", fmt::format("{} extremes are as great as the greatest and alternate in sign, for {} free "
                                    "dimension{}{}.",
                                    extremes.alternating, extremes.free, extremes.free == 1 ? "" : "s",
                                    least ? ": no design near this one has a smaller greatest error" : ""));
}

}  // namespace

std::string extremes_text(const Problem& problem, const Design& design, const std::string& what, Unit unit) {
    const ErrorExtremes extremes = error_extremes_of(problem, design);
    Table table{{Align::left, Align::point, Align::left, Align::point}, {}};
    for (const auto& e : extremes.all)
        table.rows.push_back({what, number_text(place_of(problem, design, e.share), 6), "is",
                              value_with_unit(e.error, unit, problem.units)});
    return to_text(table, 2) + alternation_text(problem, extremes);
}

std::string error_section(const Problem& problem, const Design& design, bool colour) {
    if (problem.function) return function_section(problem, design, colour);
    return problem.followed ? followed_section(problem, design, colour) : std::string();
}

}  // namespace mechwright
