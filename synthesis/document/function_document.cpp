#include "synthesis/document/function_document.h"

#include "synthesis/document/fields.h"
#include "synthesis/mechanism/function_target.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/error_extremes.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

using namespace names;

}  // namespace

Json function_document(const Problem& problem, const Design* design) {
    const FunctionTarget& f = *problem.function;
    Json json = Json::object();
    if (!f.expression.empty()) {
        json[of_function("expression")] = f.expression;
        json[of_function("x")] = {f.from, f.to};
    } else {
        json[of_function("samples")] = Json::array();
        for (const Vector<double>& s : f.samples)
            json[of_function("samples")].push_back({s.x, s.y});
    }
    // Other methods pay no attention to them.
    if (!f.accuracy_points.empty() && problem.solver.method == "exact")
        json[of_function("accuracy_points")] = f.accuracy_points;
    if (!design) return json;
    const ErrorExtremes extremes = error_extremes_of(problem, *design);
    json[of_function("extremes")] = Json::array();
    for (const auto& e : extremes.all)
        json[of_function("extremes")].push_back(
            {{of_error("x"), place_of(problem, *design, e.share)},
             {of_error("error"), in_file_unit(e.error, error_unit(problem), problem.units)}});
    json[of_function("alternating")] = extremes.alternating;
    json[of_function("free")] = extremes.free;
    return json;
}

}  // namespace mechwright
