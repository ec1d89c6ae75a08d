#include "synthesis/document/given_document.h"

#include <string>
#include <utility>

#include "synthesis/document/fields.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/affine.h"
#include "synthesis/problem/units.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

using namespace names;

/// A multiple of another dimension, or a sum as files write it; its constant in the file's unit.
Json given_tie(const Problem& problem, Affine tie, double constant) {
    const auto& dimensions = problem.mechanism->dimensions;
    tie.constant = constant;
    if (tie.terms.size() > 1 || tie.constant != 0)
        return text_of(tie, [&](std::size_t i) { return std::string(dimensions[i].name); });
    const auto& [other, times] = tie.terms.front();
    return {{of_tie("of"), dimensions[other].name}, {of_tie("times"), times}};
}

template <class Outside>
Json given_range(const DimensionRange& range, const Outside& outside) {
    if (!range.choices.empty()) {
        Json choices = Json::array();
        for (const double choice : range.choices)
            choices.push_back(outside(choice));
        return {{of_choices("choices"), std::move(choices)}};
    }
    Json given{{of_range("min"), outside(range.min)}, {of_range("max"), outside(range.max)}};
    if (range.step > 0) given[of_range("step")] = outside(range.step);
    return given;
}

}  // namespace

Json given_dimensions(const Problem& problem) {
    Json given = Json::object();
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        const DimensionRange& range = problem.dimensions[i];
        if (!range.named) continue;
        const Dimension& dimension = problem.mechanism->dimensions[i];
        const auto outside = [&](double x) { return in_file_unit(x, unit_of(dimension.kind), problem.units); };
        if (range.tied())
            given[std::string(dimension.name)] = given_tie(problem, range.tie, outside(range.tie.constant));
        else if (range.fixed())
            given[std::string(dimension.name)] = outside(range.min);
        else
            given[std::string(dimension.name)] = given_range(range, outside);
    }
    return given;
}

Json units_document(const Units& units) {
    Json json{{of_units("angle"), units.degrees ? "deg" : "rad"}, {of_units("length"), units.length}};
    if (!units.force.empty()) json[of_units("force")] = units.force;
    if (!units.mass.empty()) json[of_units("mass")] = units.mass;
    return json;
}

Json given_range_of_use(const Problem& problem) {
    const auto outside = [&](double input) {
        return in_file_unit(input, input_unit(*problem.mechanism), problem.units);
    };
    return {{of_use("from"), keys::use_begins[0]},
            {of_use("to"), keys::use_ends[0]},
            {of_use("before"), outside(problem.use->before)},
            {of_use("after"), outside(problem.use->after)}};
}

}  // namespace mechwright
