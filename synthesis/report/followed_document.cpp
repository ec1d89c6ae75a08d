#include "synthesis/report/followed_document.h"

#include <fmt/format.h>

#include "synthesis/problem/units.h"
#include "synthesis/report/error_extremes.h"
#include "synthesis/report/sections.h"
#include "synthesis/report/table.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

/// In the problem's unit.
double crank_angle_at(const Problem& problem, const Design& design, double share) {
    const std::size_t input = problem.mechanism->function_scales;
    return in_file_unit(design.dimensions[input] + share * design.dimensions[input + 1], Unit::angle, problem.units);
}

}  // namespace

Json followed_document(const Problem& problem, const Design* design) {
    Json json = Json::object();
    json["full_turn"] = problem.followed->full_turn;
    if (!design) return json;
    const ErrorExtremes extremes = error_extremes_of(problem, *design);
    json["extremes"] = Json::array();
    for (const auto& e : extremes.all)
        json["extremes"].push_back({{"crank_angle", crank_angle_at(problem, *design, e.share)}, {"distance", e.error}});
    json["alternating"] = extremes.alternating;
    json["free"] = extremes.free;
    return json;
}

std::string followed_section(const Problem& problem, const Design& design, bool colour) {
    const ErrorExtremes extremes = error_extremes_of(problem, design);
    std::string text =
        heading(fmt::format("{} from crank angle {} to {}", problem.followed->shape == Followed::line ? "Line" : "Arc",
                            number_text(crank_angle_at(problem, design, 0), 6),
                            number_text(crank_angle_at(problem, design, 1), 6)),
                colour);
    Table table{{Align::left, Align::point, Align::left, Align::point}, {}};
    for (const auto& e : extremes.all)
        table.rows.push_back({"distance at crank angle", number_text(crank_angle_at(problem, design, e.share), 6), "is",
                              value_with_unit(e.error, Unit::length, problem.units)});
    return text + to_text(table, 2) + alternation_text(extremes);
}

}  // namespace mechwright
