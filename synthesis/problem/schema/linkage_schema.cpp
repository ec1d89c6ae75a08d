#include "synthesis/problem/schema/linkage_schema.h"

#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/mechanism/cam/read/schema.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/kinds_with_sections.h"
#include "synthesis/target/names.h"

namespace mechwright::schema {

Json is_named(std::string_view name) {
    return {{"properties", {{"mechanism", {{"const", name}}}}}, {"required", {"mechanism"}}};
}

Json of_linkage() {
    Json sides = one_of(std::array{"left", "right", "ahead", "behind", "either"});
    Json side{{"type", "object"},
              {"properties", {{"side", sides}, {"from", {{"type", "string"}}}, {"to", {{"type", "string"}}}}},
              {"required", {"side"}},
              {"additionalProperties", false}};
    Json larger{{"type", "object"},
                {"properties", {{"group", {{"type", "string"}}}, {"index", {{"type", "integer"}, {"minimum", 1}}}}},
                {"required", {"index"}},
                {"additionalProperties", false}};
    Json tie = table_of(keys::tie);
    tie["properties"]["of"].update(Json{{"type", "string"}});
    Json dimension = range_of();
    dimension["anyOf"].push_back(std::move(tie));
    dimension["anyOf"].push_back({{"type", "string"}});
    Json points = list_of({{"type", "number"}});
    points["minItems"] = points["maxItems"] = 2;
    Json properties{{"dimensions", named(name_pattern, std::move(dimension))},
                    {"links", named(name_pattern, named(name_pattern, coordinates()))},
                    {"assembly", named(name_pattern, any_of({std::move(sides), std::move(side), std::move(larger)}))},
                    {"sketch", {{"properties", {{"points", named(name_pattern, std::move(points))}}}}},
                    {"signals", signals()}};
    properties["links"]["required"] = {"frame"};
    properties["instant"] = false;
    for (const reading::KindWithSections& kind : reading::kinds_with_sections())
        for (const std::string_view section : kind.sections)
            properties[std::string(section)] = false;
    properties["function"]["required"] = {"signal"};
    for (const char* name : {"path", "line", "arc"})
        properties[name]["required"] = {"point"};
    properties["poses"]["required"] = {"point", "link"};
    for (const std::string_view name : repeated_sections)
        properties[std::string(name)]["items"] = {{"required", properties[std::string(name)]["required"]}};
    return where(is_named("linkage"), {{"properties", std::move(properties)}, {"required", {"links", "drive"}}});
}

Json drives(const Key& key) {
    Json one = table_of(keys::drive);
    one["properties"]["slide"].update(any_of({Json{{"type", "string"}}, Json{{"type", "integer"}, {"minimum", 1}}}));
    Json& segment = one["properties"]["segment"]["items"]["properties"];
    segment["law"].update(one_of(cam_law_names()));
    Json end{{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
    for (const Key& derivative : keys::end_of_polynomial)
        end["properties"][std::string(derivative.name)] = with_meaning({{"type", "number"}}, derivative.meaning);
    for (const char* side : {"start", "end"})
        segment[side].update(any_of({list_of({{"type", "number"}}), one_of(keys::ends_of_polynomials), end}));
    one["properties"]["segment"]["minItems"] = 1;
    one["properties"]["segment"]["maxItems"] = MotionProgram::most_segments;
    one["oneOf"] = {{{"required", {"link"}}}, {{"required", {"slide"}}}};
    return with_meaning(any_of({one, list_of(one)}), key.meaning);
}

}  // namespace mechwright::schema
