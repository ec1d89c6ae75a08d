#include "synthesis/target/function/document.h"

#include <fmt/format.h>

#include "synthesis/document/fields.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/alternation/error_extremes.h"
#include "synthesis/target/function/function_target.h"
#include "synthesis/target/over_input/document.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

using namespace names;

}  // namespace

Json function_document(const Problem& problem, const InputTask& task, const Design* design) {
    const FunctionTarget& f = *task.asked.function;
    Json json = named(task);
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
    const ErrorExtremes extremes = error_extremes_of(problem, task, *design);
    json[of_function("extremes")] = Json::array();
    for (const auto& e : extremes.all)
        json[of_function("extremes")].push_back(
            {{of_error("x"), place_of(problem, task, *design, e.share)},
             {of_error("error"), in_file_unit(e.error, task.unit(), problem.units)}});
    json[of_function("alternating")] = extremes.alternating;
    json[of_function("free")] = extremes.free;
    return json;
}

namespace claims {

std::shared_ptr<const FunctionTarget> read_function(Reader& in, const Json& json, const std::string& place) {
    auto target = std::make_shared<FunctionTarget>();
    if (const Json* expression = member(json, of_function("expression"))) {
        target->expression = in.text(expression, place + ".expression");
        const auto x = in.numbers(member(json, of_function("x")), place + ".x", 2, false);
        if (x.size() != 2 || !(x[0] < x[1])) return in.fail(place + ".x is not [from, to]"), nullptr;
        target->from = x[0];
        target->to = x[1];
    } else {
        target->samples = in.points(member(json, of_function("samples")), place + ".samples", most_points);
        for (std::size_t i = 1; i < target->samples.size(); ++i)
            if (!(target->samples[i].x > target->samples[i - 1].x)) in.fail(place + ".samples do not rise in x");
        if (target->samples.size() < 2) in.fail(place + ".samples are fewer than two");
    }
    if (const Json* points = member(json, of_function("accuracy_points")))
        target->accuracy_points = in.numbers(points, place + ".accuracy_points", most_points, false);
    if (!in.understood()) return nullptr;
    if (const std::string why = complete(*target); !why.empty()) return in.fail(place + ": " + why), nullptr;
    return target;
}

}  // namespace claims

}  // namespace mechwright
