#include "synthesis/problem/schema/json_schema.h"

#include <cmath>
#include <utility>

#include "synthesis/problem/schema/keys.h"

namespace mechwright::schema {

namespace {

Json number_of(std::string_view type, const Limits& limits) {
    Json schema{{"type", type}};
    if (std::isfinite(limits.least)) schema[limits.above ? "exclusiveMinimum" : "minimum"] = limits.least;
    if (std::isfinite(limits.most)) schema[limits.below ? "exclusiveMaximum" : "maximum"] = limits.most;
    return schema;
}

/// A list of so many numbers.
Json numbers_of(std::size_t least, std::size_t most) {
    Json schema = list_of({{"type", "number"}});
    schema["minItems"] = least;
    schema["maxItems"] = most;
    return schema;
}

Json shape_of(const Key& key) {
    switch (key.shape) {
        case Shape::number: return number_of("number", key.limits);
        case Shape::whole_number: return number_of("integer", key.limits);
        case Shape::flag: return {{"type", "boolean"}};
        case Shape::text: return {{"type", "string"}};
        case Shape::word: return one_of(key.words);
        case Shape::word_list: return any_of({one_of(key.words), list_of(one_of(key.words))});
        case Shape::texts: return list_of({{"type", "string"}});
        case Shape::numbers: return list_of(number_of("number", key.limits));
        case Shape::open_numbers: return list_of({{"type", {"number", "null"}}});
        case Shape::ends: return numbers_of(2, 2);
        case Shape::pairs: return list_of(numbers_of(2, 2));
        case Shape::poses: return list_of(numbers_of(2, 3));
        case Shape::range: return range_of(key.limits);
        case Shape::tied_range: {
            Json tied = range_of(key.limits);
            Json tie = table_of(keys::tie);
            tie["properties"]["of"].update(Json{{"type", "string"}});
            tied["anyOf"].push_back(std::move(tie));
            tied["anyOf"].push_back({{"type", "string"}});
            return tied;
        }
        case Shape::range_or_sum: {
            Json schema = range_of(key.limits);
            schema["anyOf"].push_back({{"type", "string"}});
            return schema;
        }
        case Shape::expression: return expression();
        case Shape::place: return any_of({Json{{"type", "string"}}, coordinates()});
        case Shape::ranges: return list_of(range_of(key.limits));
        case Shape::table: return table_of(key.below);
        case Shape::tables: return list_of(table_of(key.below));
        case Shape::names:
        case Shape::name:
        case Shape::value: break;
    }
    return Json::object();
}

}  // namespace

Json of(const Key& key) { return with_meaning(shape_of(key), key.meaning); }

Json table_of(std::span<const Key> keys) {
    Json properties = Json::object(), required = Json::array();
    for (const Key& key : keys) {
        properties[std::string(key.name)] = of(key);
        if (key.required) required.push_back(key.name);
    }
    Json schema{{"type", "object"}, {"properties", std::move(properties)}};
    if (!required.empty()) schema["required"] = std::move(required);
    schema["additionalProperties"] = false;
    return schema;
}

Json list_of(Json entry) { return {{"type", "array"}, {"items", std::move(entry)}}; }

Json any_of(std::vector<Json> schemas) { return {{"anyOf", std::move(schemas)}}; }

Json definition(std::string_view name) { return {{"$ref", "#/definitions/" + std::string(name)}}; }

Json range_of(const Limits& limits) { return any_of({number_of("number", limits), definition("range")}); }

Json named(std::string_view names, Json each) {
    return {{"type", "object"}, {"propertyNames", {{"pattern", names}}}, {"additionalProperties", std::move(each)}};
}

namespace {

/// A signal: exactly one of the keys that say what it is, with what may stand beside it.
Json signal() {
    const Json text{{"type", "string"}}, number{{"type", "number"}};
    Json two = list_of(text);
    two["minItems"] = two["maxItems"] = 2;
    const Json terms = {{"type", "object"}, {"minProperties", 1}, {"additionalProperties", number}};
    const auto of = [](std::vector<std::string> required, Json properties) {
        Json table{{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
        table["required"] = required;
        return table;
    };
    return any_of(
        {of({"angle"}, {{"angle", text}, {"to", text}, {"near", number}}), of({"x"}, {{"x", text}, {"on", text}}),
         of({"y"}, {{"y", text}, {"on", text}}),
         of({"along", "point"}, {{"along", number}, {"point", text}, {"on", text}}),
         of({"distance"}, {{"distance", two}}), of({"from-line", "point"}, {{"from-line", two}, {"point", text}}),
         of({"slide"}, {{"slide", any_of({text, Json{{"type", "integer"}, {"minimum", 1}}})}}),
         of({"speed-of"}, {{"speed-of", text}}), of({"acceleration-of"}, {{"acceleration-of", text}}),
         of({"curvature-of"}, {{"curvature-of", text}}), of({"transmission-angle"}, {{"transmission-angle", text}}),
         of({"sum"}, {{"sum", terms}}), of({"ratio"}, {{"ratio", two}})});
}

}  // namespace

Json signals() { return named(name_pattern, signal()); }

Json with_meaning(Json schema, std::string_view meaning) {
    Json all{{"description", meaning}};
    all.update(schema);
    return all;
}

Json where(Json condition, Json schema) { return {{"if", std::move(condition)}, {"then", std::move(schema)}}; }

Json published(std::string_view title, std::string_view meaning, Json schema) {
    Json all{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
    all.update(with_meaning(std::move(schema), meaning));
    return all;
}

Json expression() { return any_of({Json{{"type", "number"}}, Json{{"type", "string"}}}); }

Json coordinates() {
    Json pair = list_of(expression());
    pair["minItems"] = 2;
    pair["maxItems"] = 2;
    return any_of(
        {std::move(pair), Json{{"type", "object"},
                               {"properties",
                                {{"length", with_meaning(expression(), "Distance from the link's origin.")},
                                 {"angle", with_meaning(expression(), "Direction, from the link's x axis.")}}},
                               {"required", {"length", "angle"}},
                               {"additionalProperties", false}}});
}

}  // namespace mechwright::schema
