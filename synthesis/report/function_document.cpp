#include "synthesis/report/function_document.h"

#include <fmt/format.h>

#include "synthesis/mechanism/function_target.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/error_extremes.h"
#include "synthesis/report/sections.h"
#include "synthesis/report/table.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

double x_of(const FunctionTarget& f, double share) { return f.from + share * (f.to - f.from); }

}  // namespace

Json function_document(const Problem& problem, const Design* design) {
    const FunctionTarget& f = *problem.function;
    Json json = Json::object();
    if (!f.expression.empty()) {
        json["expression"] = f.expression;
        json["x"] = {f.from, f.to};
    } else {
        json["samples"] = Json::array();
        for (const Vector<double>& s : f.samples)
            json["samples"].push_back({s.x, s.y});
    }
    // Other methods pay no attention to them.
    if (!f.accuracy_points.empty() && problem.solver.method == "exact") json["accuracy_points"] = f.accuracy_points;
    if (!design) return json;
    const ErrorExtremes extremes = error_extremes_of(problem, *design);
    json["extremes"] = Json::array();
    for (const auto& e : extremes.all)
        json["extremes"].push_back(
            {{"x", x_of(f, e.share)}, {"error", in_file_unit(e.error, error_unit(problem), problem.units)}});
    json["alternating"] = extremes.alternating;
    json["free"] = extremes.free;
    return json;
}

std::string function_section(const Problem& problem, const Design& design, bool colour) {
    const FunctionTarget& f = *problem.function;
    const ErrorExtremes extremes = error_extremes_of(problem, design);
    const std::string what = f.expression.empty() ? fmt::format("{} samples", f.samples.size())
                                                  : fmt::format("{} from x = {} to {}", f.expression, f.from, f.to);
    std::string text = heading("Function: " + what, colour);
    Table table{{Align::left, Align::point, Align::left, Align::point}, {}};
    for (const auto& e : extremes.all)
        table.rows.push_back({"error at x =", number_text(x_of(f, e.share), 6), "is",
                              value_with_unit(e.error, error_unit(problem), problem.units)});
    text += to_text(table, 2);
    return text + alternation_text(extremes);
}

}  // namespace mechwright
