#include "synthesis/problem/schema/problem_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/schema/json_schema.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/schema/linkage_schema.h"
#include "synthesis/problem/sections/kinds_with_sections.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/target/names.h"

namespace mechwright {

namespace {

using namespace schema;
using reading::stands_in_dimensions;

using Names = std::vector<std::string_view>;

void add_name(Names& names, std::string_view name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

Limits limits_of(const Dimension& dimension) { return dimension.kind == DimensionKind::length ? positive : Limits{}; }

/// Dimensions of the same kind that one can be tied to.
Names ties_of(const Mechanism& mechanism, const Dimension& dimension) {
    Names names;
    for (const Dimension& d : whole_of(mechanism).dimensions)
        if (!d.of_segment && d.name != dimension.name && scales(d.kind) == scales(dimension.kind))
            names.push_back(d.name);
    return names;
}

Json dimension_of(const Mechanism& mechanism, const Dimension& dimension) {
    Json tie = table_of(keys::tie);
    tie["properties"]["of"].update(one_of(ties_of(mechanism, dimension)));
    Json schema = range_of(limits_of(dimension));
    schema["anyOf"].push_back(std::move(tie));
    schema["anyOf"].push_back({{"type", "string"}});
    return with_meaning(std::move(schema), dimension.meaning);
}

Json assembly_of(const Mechanism& mechanism) {
    Names words(mechanism.assemblies.begin(), mechanism.assemblies.end());
    words.push_back("either");
    return with_meaning(one_of(words), fmt::format("How the links are put together. Preset: {}.", words.front()));
}

Json dimensions_of(const Mechanism& mechanism) {
    Json properties = Json::object(), required = Json::array();
    for (const Dimension& dimension : mechanism.dimensions) {
        if (!stands_in_dimensions(dimension)) continue;
        properties[std::string(dimension.name)] = dimension_of(mechanism, dimension);
        if (dimension.required) required.push_back(dimension.name);
    }
    if (mechanism.assemblies.size() > 1) properties["assembly"] = assembly_of(mechanism);
    return {{"type", "object"},
            {"properties", std::move(properties)},
            {"required", std::move(required)},
            {"additionalProperties", false}};
}

/// A grade of ISO 286, a class of ISO 2768, or a table that says a deviation.
Json deviation() {
    std::vector<std::string> grades;
    for (int grade = keys::least_grade; grade <= keys::greatest_grade; ++grade)
        grades.push_back(fmt::format("IT{}", grade));
    grades.insert(grades.end(), keys::general_tolerances.begin(), keys::general_tolerances.end());
    Json table = table_of(keys::deviation);
    table["properties"]["grade"].update(one_of(grades));
    return any_of({one_of(grades), std::move(table)});
}

Json tolerance_of(const Mechanism& mechanism) {
    const Json deviations = any_of({definition("deviation")});
    Json properties{{"lengths", with_meaning(deviations, "Every length that is not named by itself.")}};
    for (const Dimension& dimension : mechanism.dimensions)
        if (stands_in_dimensions(dimension))
            properties[std::string(dimension.name)] = with_meaning(deviations, dimension.meaning);
    return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

/// Those over the whole motion among them, where it has them.
std::vector<std::string> quantities_of(const Mechanism& mechanism) {
    std::vector<std::string> names;
    for (const Quantity& quantity : mechanism.quantities)
        names.push_back(quantity.name);
    for (const Quantity& quantity : mechanism.quantities)
        if (mechanism.input && quantity.of_motion) names.push_back(quantity.name + std::string(whole_suffix));
    return names;
}

/// One name, or a list of some.
Json quantity_or_list(const Json& quantity) { return any_of({quantity, list_of(quantity)}); }

/// What the mechanism has by names of its own, wherever a file names it.
Json named_by(const Mechanism& mechanism) {
    const Json quantity = quantity_among(quantities_of(mechanism), mechanism.as_linkage.has_value());
    const Json term{
        {"properties", {{"minimize", quantity_or_list(quantity)}, {"maximize", quantity_or_list(quantity)}}}};
    Json properties{{"dimensions", dimensions_of(mechanism)},
                    {"require", {{"items", {{"properties", {{"quantity", quantity}}}}}}},
                    {"objective", any_of({Json{{"type", "object"}, {"allOf", {term}}}, list_of(term)})},
                    {"study", {{"properties", {{"tolerance", tolerance_of(mechanism)}}}}}};
    return {{"properties", std::move(properties)}};
}

/// Sections that files of a mechanism cannot have.
Names foreign_sections(const Mechanism& mechanism) {
    Names own, foreign;
    for (const Setting& setting : mechanism.settings)
        add_name(own, setting.section);
    for (const auto& other : mechanisms())
        for (const Setting& setting : other->settings)
            if (std::find(own.begin(), own.end(), setting.section) == own.end()) add_name(foreign, setting.section);
    for (const reading::KindWithSections& kind : reading::kinds_with_sections())
        if (kind.mechanism != mechanism.name) foreign.insert(foreign.end(), kind.sections.begin(), kind.sections.end());
    const auto offer = [&](std::string_view target) {
        if (std::find(mechanism.targets.begin(), mechanism.targets.end(), target) == mechanism.targets.end())
            foreign.push_back(target);
    };
    std::for_each(repeated_sections.begin(), repeated_sections.end(), offer);
    if (!mechanism.as_linkage) foreign.insert(foreign.end(), {"signals", "room", "region"});
    offer("instant");
    return foreign;
}

/// What files of one mechanism alone can say, and what they have to.
Json of_mechanism(const Mechanism& mechanism) {
    Json schema = named_by(mechanism);
    schema["required"] = {"dimensions"};
    schema["properties"]["motion"] = {{"properties", {{"at", false}}}};
    for (const char* key : {"from", "to", "before", "after"})
        if (!mechanism.point) schema["properties"]["motion"]["properties"][key] = false;
    for (const std::string_view name : sections_of_linkage)
        schema["properties"][std::string(name)] = false;
    if (mechanism.as_linkage) schema["properties"]["signals"] = signals();
    for (const std::string_view name : foreign_sections(mechanism))
        schema["properties"][std::string(name)] = false;
    for (const std::string_view target : repeated_sections)
        if (auto& section = schema["properties"][std::string(target)]; !section.is_boolean()) {
            for (const char* key : {"point", "link", "crank-start", "body-angle", "name", "weight", "signal"})
                section["properties"][key] = false;
            // One that is headed in double brackets is the same as one in single ones.
            section["items"] = {{"properties", section["properties"]}};
            section["maxItems"] = 1;
        }
    const reading::KindWithSections* own = reading::sections_of(mechanism);
    if (own == nullptr) return where(is_named(mechanism.name), std::move(schema));
    own->limit_files(mechanism, schema);
    return where(own->is_meant(mechanism), std::move(schema));
}

/// A section that may be repeated.
Json one_or_several(const Key& key, Json one) {
    Json list = list_of(one);
    list["minItems"] = 1;
    return with_meaning(any_of({std::move(one), std::move(list)}), key.meaning);
}

/// Names of all mechanisms' dimensions with what they are, for editors that look no further.
Json all_dimensions() {
    Json properties = Json::object();
    for (const auto& mechanism : mechanisms())
        for (const Dimension& dimension : mechanism->dimensions)
            if (const std::string name(dimension.name); stands_in_dimensions(dimension) && !properties.contains(name))
                properties[name] = {{"description", dimension.meaning}};
    properties["assembly"] = {{"description", "How the links are put together."}};
    return {{"type", "object"}, {"properties", std::move(properties)}};
}

Json objectives(const Key& key) {
    const Json text{{"type", "string"}};
    Json one = table_of(keys::objective);
    one["properties"]["minimize"].update(any_of({text, list_of(text)}));
    one["properties"]["maximize"].update(any_of({text, list_of(text)}));
    one["oneOf"] = {{{"required", {"minimize"}}}, {{"required", {"maximize"}}}};
    Json list = list_of(one);
    list["minItems"] = 1;
    return with_meaning(any_of({std::move(one), std::move(list)}), key.meaning);
}

Json function_of(const Key& key) {
    Json schema = of(key);
    Json points = list_of({{"type", "number"}});
    points["minItems"] = 3;
    points["maxItems"] = 5;
    schema["properties"]["accuracy_points"].update(
        any_of({Json{{"type", "integer"}, {"minimum", 3}, {"maximum", 5}}, std::move(points)}));
    schema["oneOf"] = {{{"required", {"expression", "x"}}}, {{"required", {"samples"}}}};
    return schema;
}

/// A room or a region: whole mechanisms, or some parts by their names.
Json with_parts(const Key& key) {
    Json schema = of(key);
    schema["items"]["properties"]["of"].update(
        any_of({Json{{"type", "string"}}, Json{{"type", "array"}, {"items", {{"type", "string"}}}, {"minItems", 1}}}));
    return schema;
}

Json rooms(const Key& key) {
    Json schema = with_parts(key), words = Json::array();
    for (const std::string_view word : keys::turns_of_rooms)
        words.push_back(word);
    schema["items"]["properties"]["direction"].update(
        any_of({Json{{"type", "number"}}, Json{{"enum", std::move(words)}}}));
    schema["items"]["properties"]["screen"]["minItems"] = 3;
    return schema;
}

Json regions(const Key& key) {
    Json schema = with_parts(key), pair = list_of({{"type", "number"}});
    pair["minItems"] = pair["maxItems"] = 2;
    Json& properties = schema["items"]["properties"];
    properties["polygon"]["minItems"] = 3;
    properties["circle"]["properties"]["centre"].update(pair);
    properties["half-plane"]["properties"]["through"].update(pair);
    Json shapes = Json::array();
    for (const char* shape : {"polygon", "circle", "half-plane", "link"})
        shapes.push_back({{"required", {shape}}});
    schema["items"]["oneOf"] = std::move(shapes);
    return schema;
}

Json requirements(const Key& key) {
    Json schema = of(key);
    schema["items"]["anyOf"] = {{{"required", {"equal"}}}, {{"required", {"min"}}}, {{"required", {"max"}}}};
    return schema;
}

/// The paths of values that a study may vary: the name of a section, then what is in it.
Json values_by_path() {
    std::string sections;
    for (const Key& key : keys::of_file())
        if (key.name != "schema" && key.name != "study")
            sections += (sections.empty() ? "" : "|") + std::string(key.name);
    Json list{{"type", "array"}, {"minItems", 1}};
    Json follows{{"type", "object"},
                 {"properties", {{"expression", {{"description", "A formula of other values of this study."}}}}},
                 {"required", {"expression"}},
                 {"additionalProperties", {{"type", "string"}}}};
    Json deeper{{"type", "object"},
                {"not", {{"anyOf", {{{"required", {"from"}}}, {{"required", {"expression"}}}}}}},
                {"additionalProperties", definition("values")}};
    Json values = any_of({std::move(list), table_of(keys::steps), std::move(follows), std::move(deeper)});
    return {{"pattern", "^(" + sections + ")(\\..+)?$"}, {"values", std::move(values)}};
}

Json study_of(const Key& key, const std::string& pattern) {
    Json schema = table_of(keys::study);
    Json& properties = schema["properties"];
    properties["case"].update(list_of({{"type", "object"},
                                       {"properties", {{"name", {{"type", "string"}}}}},
                                       {"required", {"name"}},
                                       {"patternProperties", {{pattern, Json::object()}}},
                                       {"additionalProperties", false}}));
    schema["patternProperties"] = {{pattern, definition("values")}};
    return with_meaning(std::move(schema), key.meaning);
}

}  // namespace

nlohmann::ordered_json problem_schema(const std::vector<std::string_view>& methods) {
    const Json by_path = values_by_path();
    Json schema = table_of(keys::of_file());
    Json& properties = schema["properties"];
    Names names;
    for (const auto& mechanism : mechanisms())
        add_name(names, mechanism->name);
    const auto key = [](std::string_view name) -> const Key& { return *find_key(keys::file, name); };
    add_name(names, "linkage");
    properties["mechanism"].update(one_of(names));
    properties["drive"] = drives(key("drive"));
    properties["dimensions"].update(all_dimensions());
    for (const reading::KindWithSections& kind : reading::kinds_with_sections())
        kind.complete_schema(properties);
    properties["objective"] = objectives(key("objective"));
    properties["require"] = requirements(key("require"));
    properties["room"] = rooms(key("room"));
    properties["region"] = regions(key("region"));
    properties["solver"]["properties"]["method"].update(one_of(methods));
    for (const std::string_view target : repeated_sections)
        properties[std::string(target)] =
            one_or_several(key(target), target == "function" ? function_of(key(target)) : table_of(key(target).below));
    properties["study"] = study_of(key("study"), by_path["pattern"]);
    Json by_mechanism = Json::array();
    for (const auto& mechanism : mechanisms())
        by_mechanism.push_back(of_mechanism(*mechanism));
    by_mechanism.push_back(of_linkage());
    schema["allOf"] = std::move(by_mechanism);
    schema["definitions"] = {{"range", any_of({table_of(keys::dimension_range), table_of(keys::dimension_choices)})},
                             {"values", by_path["values"]},
                             {"deviation", deviation()}};
    return published("mechwright problem", "A problem for mechwright: a mechanism, and what it has to do.",
                     std::move(schema));
}

}  // namespace mechwright
