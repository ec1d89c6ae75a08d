#include "synthesis/problem/toml/made_table.h"

#include <fmt/format.h>

#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

#include "synthesis/problem/text.h"

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

}  // namespace

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
    using Flags = toml::format_flags;
    constexpr Flags indented = Flags::indent_array_elements | Flags::allow_unicode_strings;
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << toml::toml_formatter(table, indented) << '\n';
    return text.str();
}

}  // namespace mechwright::reading
