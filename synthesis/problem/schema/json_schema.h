#pragma once
/// \file
/// Lists of keys as JSON Schema (draft 7, which editors of TOML and JSON read).

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/schema/key.h"

namespace mechwright::schema {

using Json = nlohmann::ordered_json;

/// What may stand behind a key. Of Shape::name, names and value it has the meaning alone.
Json of(const Key& key);

/// A table with these keys and no others.
Json table_of(std::span<const Key> keys);

/// A list.
Json list_of(Json entry);

/// A string among some.
template <class Words>
Json one_of(const Words& words) {
    Json all = Json::array();
    for (const auto& word : words)
        all.push_back(word);
    return {{"type", "string"}, {"enum", std::move(all)}};
}

/// What names quantities of signals, rooms and regions have: a file makes them.
inline constexpr std::string_view quantity_of_links =
    "^[A-Za-z][A-Za-z0-9_-]*[.](width|height|area|self-distance|swept-area|uncovered|margin|time-ratio|"
    "((speed|acceleration|jerk)[.])?((least|greatest|range|mean|rms|deviation)([(][^()]*[)])?|at[(][^()]*[)]))"
    "([.]whole)?$";

/// Either of some schemas.
Json any_of(std::vector<Json> schemas);

/// What stands under this name in the definitions of the schema; "range" is { min, max } with or without start.
Json definition(std::string_view name);

/// A number, or a range of numbers.
Json range_of(const Limits& limits = {});

/// A number, or a sum of dimensions as a linkage's numbers can be; two of them as a place.
Json expression();
Json coordinates();

/// One of a mechanism's quantities, or one of a signal, room or region where it can have some.
template <class Words>
Json quantity_among(const Words& words, bool is_of_links) {
    if (!is_of_links) return one_of(words);
    return any_of({one_of(words), Json{{"type", "string"}, {"pattern", quantity_of_links}}});
}

/// An object whose members have names of the file's own, which meet a pattern.
Json named(std::string_view names, Json each);
inline constexpr std::string_view name_pattern = "^[A-Za-z][A-Za-z0-9_-]*$";

/// The section of signals.
Json signals();

/// The schema with what is to be told of it.
Json with_meaning(Json schema, std::string_view meaning);

/// `schema` for documents that meet `condition`.
Json where(Json condition, Json schema);

/// The head of a published schema.
Json published(std::string_view title, std::string_view meaning, Json schema);

}  // namespace mechwright::schema
