#include "synthesis/document/result_schema.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "synthesis/document/fields.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/schema/json_schema.h"
#include "synthesis/target/names.h"

namespace mechwright {

namespace {

using namespace schema;

using Names = std::vector<std::string_view>;

template <class Text>
void add_name(std::vector<Text>& names, std::string_view name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
}

/// What mechanisms of one name have: cams come in several kinds.
struct Kinds {
    std::string_view name;
    Names dimensions{};
    std::vector<std::string> quantities{};  ///< those over the whole motion among them
    Names settings{};
    bool is_of_links = false;  ///< problems can have signals, rooms and regions
};

std::vector<Kinds> all_kinds() {
    std::vector<Kinds> all;
    for (const auto& mechanism : mechanisms()) {
        if (all.empty() || all.back().name != mechanism->name) all.push_back({mechanism->name});
        for (const Dimension& dimension : mechanism->dimensions)
            add_name(all.back().dimensions, dimension.name);
        const auto with_whole = with_whole_quantities(mechanism);
        for (const Quantity& quantity : with_whole->quantities)
            add_name(all.back().quantities, quantity.name);
        for (const Setting& setting : mechanism->settings)
            add_name(all.back().settings, setting.name);
        all.back().is_of_links = mechanism->as_linkage.has_value();
    }
    return all;
}

/// An object in which all of these names have the same kind of value, and there are no others.
template <class Text>
Json table_by(const std::vector<Text>& names, const Json& value) {
    Json properties = Json::object();
    for (const Text& name : names)
        properties[std::string(name)] = value;
    return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

const Json& number() {
    static const Json json{{"type", "number"}};
    return json;
}

Json design_of(const Kinds& kinds) {
    Json schema = table_of(fields::design);
    schema["properties"]["assembly"]["type"] = "string";
    Json properties = table_by(kinds.dimensions, number())["properties"];
    properties.update(schema["properties"]);
    schema["properties"] = std::move(properties);
    return schema;
}

/// The members that are about one design, as far as the mechanism says what is in them.
Json findings_of(const Kinds& kinds) {
    const Json quantity{{"properties", {{"quantity", quantity_among(kinds.quantities, kinds.is_of_links)}}}};
    Json objective = quantity, quantities = table_by(kinds.quantities, number());
    objective["properties"]["terms"] = {{"items", quantity}};
    if (kinds.is_of_links) quantities["patternProperties"] = {{std::string(quantity_of_links), number()}};
    return {{"design", design_of(kinds)},
            {"objective", std::move(objective)},
            {"requirements", {{"items", quantity}}},
            {"wishes", {{"items", quantity}}},
            {"quantities", std::move(quantities)}};
}

/// What is given of a dimension.
Json given() {
    return any_of({number(), table_of(fields::range), table_of(fields::choices), table_of(fields::tie),
                   Json{{"type", "string"}}});
}

Json of_kinds(const Kinds& kinds) {
    Json properties = findings_of(kinds);
    for (const std::string_view target : repeated_sections)
        properties[std::string(target)] = {{"type", "object"}};
    properties["dimensions"] = table_by(kinds.dimensions, given());
    properties["settings"] = table_by(kinds.settings, number());
    for (const char* name : {"signals", "room", "region"})
        if (!kinds.is_of_links) properties[name] = false;
    if (kinds.is_of_links) properties["signals"] = signals();
    properties["front"] = {{"items", {{"properties", findings_of(kinds)}}}};
    properties["alternatives"] = {{"items", {{"properties", {{"design", properties["design"]}}}}}};
    const Json is_of_them{{"properties", {{"mechanism", {{"const", kinds.name}}}}}};
    return where({{"properties", {{"problem", is_of_them}}}}, {{"properties", std::move(properties)}});
}

/// Where the file itself makes the names.
Json table_of_any(const Json& value) { return {{"type", "object"}, {"additionalProperties", value}}; }

/// Which assembly a larger group of links is in.
constexpr std::array larger_group{
    Key{"group", Shape::text, "The links that are placed together.", true},
    Key{"index", Shape::whole_number, "Which of its assemblies, from 1, for the start dimensions.", true}};

Json of_linkages() {
    Json design = table_of(fields::design);
    design["properties"]["assembly"].update(table_of_any(any_of({table_of(fields::side), table_of(larger_group)})));
    design["additionalProperties"] = number();
    Json properties{{"design", design},
                    {"quantities", table_of_any(number())},
                    {"dimensions", table_of_any(given())},
                    {"linkage", table_of(fields::linkage)},
                    {"signals", false},
                    {"room", false},
                    {"region", false}};
    properties["front"] = {{"items", {{"properties", properties}}}};
    properties["alternatives"] = {{"items", {{"properties", {{"design", std::move(design)}}}}}};
    Json is_one{{"properties", {{"mechanism", {{"const", "linkage"}}}}}};
    return where({{"properties", {{"problem", std::move(is_one)}}}},
                 {{"properties", std::move(properties)}, {"required", {"linkage"}}});
}

/// Of a linkage a list where targets have names.
Json one_or_several(const Key& key) {
    return with_meaning(any_of({table_of(key.below), list_of(table_of(key.below))}), key.meaning);
}

}  // namespace

nlohmann::ordered_json result_schema() {
    Json schema = table_of(fields::document);
    Json& properties = schema["properties"];
    Json point = table_of(fields::finding);
    for (Json* of : {&properties, &point["properties"]})
        for (const std::string_view target : repeated_sections)
            (*of)[std::string(target)] = one_or_several(*find_key(fields::finding, target));
    point["required"] = {"design", "verification"};
    properties["front"].update(list_of(std::move(point)));
    Names names;
    Json by_mechanism = Json::array();
    for (const Kinds& kinds : all_kinds()) {
        names.push_back(kinds.name);
        by_mechanism.push_back(of_kinds(kinds));
    }
    names.push_back("linkage");
    by_mechanism.push_back(of_linkages());
    properties["problem"]["properties"]["mechanism"].update(one_of(names));
    schema["dependencies"] = {{"status", {"alternatives", "search"}}};
    schema["allOf"] = std::move(by_mechanism);
    Json all = any_of({definition("result"), list_of(definition("result"))});
    all["definitions"]["result"] = std::move(schema);
    return published("mechwright result", "A result document of mechwright, or a list of them.", std::move(all));
}

}  // namespace mechwright
