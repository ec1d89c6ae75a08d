#include "synthesis/report/text/error_sections.h"

#include <fmt/format.h>

#include "synthesis/program/alternation/error_extremes.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"
#include "synthesis/target/followed/text.h"
#include "synthesis/target/function/text.h"

namespace mechwright {

namespace {

/// One sentence, indented; empty where nothing alternates.
std::string alternation_text(const Problem& problem, const InputTask& task, const ErrorExtremes& extremes) {
    if (extremes.alternating < 2) return {};
    const bool least = extremes.free > 0 && extremes.alternating > extremes.free && asks_for_least_error(problem, task);
    return folded("  ", fmt::format("{} extremes are as great as the greatest and alternate in sign, for {} free "
                                    "dimension{}{}.",
                                    extremes.alternating, extremes.free, extremes.free == 1 ? "" : "s",
                                    least ? ": no design near this one has a smaller greatest error" : ""));
}

}  // namespace

std::string extremes_text(const Problem& problem, const InputTask& task, const Design& design, const std::string& what,
                          int digits) {
    const ErrorExtremes extremes = error_extremes_of(problem, task, design);
    Table table{{Align::left, Align::point, Align::left, Align::point}, {}};
    for (const auto& e : extremes.all)
        table.rows.push_back({what, rounded_text(place_of(problem, task, design, e.share), digits), "is",
                              quantity_with_unit(e.error, task.unit(), problem, design, digits)});
    return to_text(table, 2) + alternation_text(problem, task, extremes);
}

std::string error_section(const Problem& problem, const Design& design, const TextStyle& style) {
    std::string text;
    for (const InputTask& task : input_tasks(problem))
        text += task.is_function() ? function_section(problem, task, design, style)
                                   : followed_section(problem, task, design, style);
    return text;
}

}  // namespace mechwright
