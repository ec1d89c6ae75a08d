// What a file says of a linkage, as documents repeat it.

#include <array>
#include <nlohmann/json.hpp>

#include "synthesis/problem/linkage/mechanism.h"
#include "synthesis/problem/toml/in_order.h"
#include "synthesis/target/names.h"

namespace mechwright::reading {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 15> describing{"units",  "dimensions", "links",   "slide", "slot",
                                                      "gear",   "belt",       "rack",    "drive", "assembly",
                                                      "sketch", "placement",  "signals", "room",  "region"};

Json json_of(const toml::node& node) {
    if (const toml::table* table = node.as_table()) {
        Json object = Json::object();
        for (const auto& [key, value] : in_order(*table))
            object[std::string(key)] = json_of(*value);
        return object;
    }
    if (const toml::array* array = node.as_array()) {
        Json list = Json::array();
        for (const toml::node& value : *array)
            list.push_back(json_of(value));
        return list;
    }
    if (const auto text = node.value_exact<std::string>()) return *text;
    if (const auto flag = node.value_exact<bool>()) return *flag;
    if (const auto whole = node.value_exact<std::int64_t>()) return *whole;
    return node.value<double>().value_or(0);
}

/// What one target says of what it guides, as a member of the object.
void add_names_of_target(Json& object, const std::string& target, const toml::node& node) {
    const toml::table* table = node.as_table();
    for (const char* key : {"name", "point", "link", "signal"})
        if (const auto name = table == nullptr ? std::nullopt : (*table)[key].value_exact<std::string>())
            object[target][key] = *name;
}

}  // namespace

Json sections_named(const toml::table& table, std::span<const std::string_view> names) {
    Json sections = Json::object();
    for (const std::string_view name : names)
        if (const toml::node* node = table.get(name)) sections[std::string(name)] = json_of(*node);
    return sections;
}

Json sections_of_linkage(const toml::table& table) {
    Json sections = sections_named(table, describing);
    if (const auto at = table["motion"]["at"].value<double>()) sections["motion"] = {{"at", *at}};
    for (const std::string_view name : repeated_sections) {
        const std::string target(name);
        const toml::node* node = table.get(target);
        if (node == nullptr) continue;
        const toml::array* list = node->as_array();
        if (list == nullptr) {
            add_names_of_target(sections, target, *node);
            continue;
        }
        Json all = Json::array();
        for (const toml::node& one : *list) {
            Json names = Json::object();
            add_names_of_target(names, target, one);
            if (names.contains(target)) all.push_back(names[target]);
        }
        // One that is headed in double brackets is the same as one in single ones.
        sections[target] = all.size() == 1 ? all.front() : all;
    }
    return sections;
}

}  // namespace mechwright::reading
