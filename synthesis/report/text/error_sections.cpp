#include "synthesis/report/text/error_sections.h"

#include <fmt/format.h>

#include "synthesis/mechanism/function_target.h"
#include "synthesis/program/error_extremes.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"

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

std::string function_section(const Problem& problem, const Design& design, bool colour) {
    const FunctionTarget& f = *problem.function;
    const ErrorExtremes extremes = error_extremes_of(problem, design);
    const std::string what = f.expression.empty() ? fmt::format("{} samples", f.samples.size())
                                                  : fmt::format("{} from x = {} to {}", f.expression, f.from, f.to);
    std::string text = heading("Function: " + what, colour);
    Table table{{Align::left, Align::point, Align::left, Align::point}, {}};
    for (const auto& e : extremes.all)
        table.rows.push_back({"error at x =", number_text(place_of(problem, design, e.share), 6), "is",
                              value_with_unit(e.error, error_unit(problem), problem.units)});
    text += to_text(table, 2);
    return text + alternation_text(problem, extremes);
}

std::string followed_section(const Problem& problem, const Design& design, bool colour) {
    const ErrorExtremes extremes = error_extremes_of(problem, design);
    std::string text =
        heading(fmt::format("{} from crank angle {} to {}", problem.followed->shape == Followed::line ? "Line" : "Arc",
                            number_text(place_of(problem, design, 0), 6), number_text(place_of(problem, design, 1), 6)),
                colour);
    Table table{{Align::left, Align::point, Align::left, Align::point}, {}};
    for (const auto& e : extremes.all)
        table.rows.push_back({"distance at crank angle", number_text(place_of(problem, design, e.share), 6), "is",
                              value_with_unit(e.error, Unit::length, problem.units)});
    return text + to_text(table, 2) + alternation_text(problem, extremes);
}

}  // namespace

std::string error_section(const Problem& problem, const Design& design, bool colour) {
    if (problem.function) return function_section(problem, design, colour);
    return problem.followed ? followed_section(problem, design, colour) : std::string();
}

}  // namespace mechwright
