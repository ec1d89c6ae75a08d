#include "synthesis/problem/toml/made_table.h"

#include <fmt/format.h>

#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

#include "synthesis/problem/text.h"
#include "synthesis/problem/toml/in_order.h"

namespace mechwright::reading {

namespace {

using Json = nlohmann::ordered_json;

/// Hands a value to `put`, which returns where it keeps it; tables and lists still empty.
template <class Put>
toml::node& put_value(const Json& json, const Put& put) {
    switch (json.type()) {
        case Json::value_t::object: return put(toml::table());
        case Json::value_t::array: return put(toml::array());
        case Json::value_t::string: return put(json.get_ref<const std::string&>());
        case Json::value_t::boolean: return put(json.get<bool>());
        case Json::value_t::number_float: return put(json.get<double>());
        default: return put(json.get<std::int64_t>());
    }
}

void fill(toml::node& node, const Json& json, const std::string& name, NodeNames& nodes);

/// Names a node before what is in it.
void name_and_fill(toml::node& node, const Json& json, std::string name, NodeNames& nodes) {
    nodes.numbers.emplace(&node, static_cast<int>(nodes.names.size()));
    nodes.names.push_back(name);
    fill(node, json, name, nodes);
}

void fill(toml::node& node, const Json& json, const std::string& name, NodeNames& nodes) {
    if (toml::table* table = node.as_table())
        for (const auto& [text, value] : json.items()) {
            const toml::source_position line{static_cast<toml::source_index>(nodes.names.size() + 1), 1};
            const toml::key key(text, toml::source_region{line, line, {}});
            name_and_fill(
                put_value(value, [&](const auto& v) -> toml::node& { return table->insert(key, v).first->second; }),
                value, name_in(name, text), nodes);
        }
    else if (toml::array* list = node.as_array())
        for (const Json& value : json) {
            toml::node& kept = put_value(value, [&](const auto& v) -> toml::node& {
                list->push_back(v);
                return list->back();
            });
            name_and_fill(kept, value, name_in(name, list->size() - 1), nodes);
        }
}

/// Numbers, texts and dates as TOML.
std::string scalar_text(const toml::node& node) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << toml::toml_formatter(node, toml::format_flags::allow_unicode_strings);
    return text.str();
}

std::string lines_of(const toml::table& table) {
    std::string text;
    for (const auto& [key, value] : in_order(table))
        text += fmt::format("{} = {}\n", key_text(key), value_text(*value));
    return text;
}

}  // namespace

std::string key_text(std::string_view key) {
    const bool bare = !key.empty() && key.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-") == std::string_view::npos;
    return bare ? std::string(key) : scalar_text(toml::value<std::string>(key));
}

std::string value_text(const toml::node& node) {
    std::string text;
    if (const toml::table* table = node.as_table()) {
        for (const auto& [key, value] : in_order(*table))
            text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key_text(key), value_text(*value));
        return text.empty() ? "{}" : fmt::format("{{ {} }}", text);
    }
    const toml::array* list = node.as_array();
    if (!list) return scalar_text(node);
    for (const toml::node& value : *list)
        text += (text.empty() ? "" : ", ") + value_text(value);
    return fmt::format("[{}]", text);
}

std::string name_in(const std::string& name, std::string_view key) {
    constexpr std::size_t longest_key = 100;
    const std::string shown = printable(key, longest_key);
    return name.empty() ? shown : fmt::format("{}.{}", name, shown);
}

std::string name_in(const std::string& name, std::size_t index) { return fmt::format("{}[{}]", name, index); }

MadeTable made_table(const Json& object) {
    MadeTable made;
    fill(made.table, object, "", made.nodes);
    return made;
}

std::string text_of(const toml::table& table) {
    std::string heads, sections;
    for (const auto& [key, node] : in_order(table)) {
        const toml::array* list = node->as_array();
        if (const toml::table* section = node->as_table())
            sections += fmt::format("\n[{}]\n{}", key_text(key), lines_of(*section));
        else if (list && list->is_array_of_tables())
            for (const toml::node& one : *list)
                sections += fmt::format("\n[[{}]]\n{}", key_text(key), lines_of(*one.as_table()));
        else
            heads += fmt::format("{} = {}\n", key_text(key), value_text(*node));
    }
    return heads + sections;
}

}  // namespace mechwright::reading
