#include "synthesis/report/function_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/mechanism/function_target.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/sections.h"
#include "synthesis/report/table.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_extremes = 40;
/// Extremes this close to the greatest are as great as it.
constexpr double as_great_within = 1e-6;

struct Extremes {
    std::vector<ErrorExtreme> all;
    int alternating = 0;
    int free = 0;
};

Extremes extremes_of(const Problem& problem, const Design& design) {
    Extremes e;
    const Mechanism& mechanism = *problem.mechanism;
    e.all = mechanism.function_extremes(*problem.function, design.assembly, design.dimensions);
    double greatest = 0;
    for (const auto& extreme : e.all)
        greatest = std::max(greatest, std::abs(extreme.error));
    double last = 0;
    for (const auto& extreme : e.all) {
        if (std::abs(extreme.error) < (1 - as_great_within) * greatest || last * extreme.error > 0) continue;
        last = extreme.error;
        ++e.alternating;
    }
    // The size of the mechanism is not counted: no angle depends on it.
    int lengths = 0;
    bool fixed_length = false;
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i) {
        const bool free = !problem.dimensions[i].fixed();
        if (mechanism.dimensions[i].kind == DimensionKind::length) {
            lengths += free;
            fixed_length = fixed_length || !free;
        }
        e.free += mechanism.dimensions[i].of_function && free;
    }
    e.free += fixed_length || lengths == 0 ? lengths : lengths - 1;
    if (e.all.size() > most_extremes) e.all.resize(most_extremes);
    return e;
}

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
    if (!design) return json;
    const Extremes extremes = extremes_of(problem, *design);
    json["extremes"] = Json::array();
    for (const auto& e : extremes.all)
        json["extremes"].push_back(
            {{"x", x_of(f, e.share)}, {"error", in_file_unit(e.error, Unit::angle, problem.units)}});
    json["alternating"] = extremes.alternating;
    json["free"] = extremes.free;
    return json;
}

std::string function_section(const Problem& problem, const Design& design, bool colour) {
    const FunctionTarget& f = *problem.function;
    const Extremes extremes = extremes_of(problem, design);
    const std::string what = f.expression.empty() ? fmt::format("{} samples", f.samples.size())
                                                  : fmt::format("{} from x = {} to {}", f.expression, f.from, f.to);
    std::string text = heading("Function: " + what, colour);
    Table table{{Align::left, Align::point, Align::left, Align::point}, {}};
    for (const auto& e : extremes.all)
        table.rows.push_back({"error at x =", number_text(x_of(f, e.share), 6), "is",
                              value_with_unit(e.error, Unit::angle, problem.units)});
    text += to_text(table, 2);
    const bool least = extremes.free > 0 && extremes.alternating > extremes.free;
    text += folded("  ", fmt::format("{} extremes are as great as the greatest and alternate in sign, for {} free "
                                     "dimension{}{}.",
                                     extremes.alternating, extremes.free, extremes.free == 1 ? "" : "s",
                                     least ? ": no design near this one has a smaller greatest error" : ""));
    return text;
}

}  // namespace mechwright
