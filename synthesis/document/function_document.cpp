#include "synthesis/document/function_document.h"

#include "synthesis/mechanism/function_target.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/error_extremes.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

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
        json["extremes"].push_back({{"x", place_of(problem, *design, e.share)},
                                    {"error", in_file_unit(e.error, error_unit(problem), problem.units)}});
    json["alternating"] = extremes.alternating;
    json["free"] = extremes.free;
    return json;
}

}  // namespace mechwright
