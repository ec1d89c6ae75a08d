#include "synthesis/problem/study/value_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <vector>

#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

/// The keys whose words tell the elements of a list of tables apart.
constexpr std::array<std::string_view, 4> naming_keys{"quantity", "minimize", "maximize", "kind"};

struct Element {
    std::size_t index = 0;
    std::string fault;
};

bool is_named_by(const toml::node& element, std::string_view word) {
    const toml::table* table = element.as_table();
    return table != nullptr && std::any_of(naming_keys.begin(), naming_keys.end(), [&](std::string_view key) {
               return (*table)[key].value_or(std::string_view()) == word;
           });
}

Element element_by_word(const toml::array& list, std::string_view word, std::string_view above) {
    std::vector<std::size_t> named;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (is_named_by(list[i], word)) named.push_back(i);
    if (named.empty())
        return {0, fmt::format("{} has no element {}: write its quantity or kind, or its number, 1 to {}",
                               quoted(above), quoted(word), list.size())};
    if (named.size() > 1)
        return {0, fmt::format("{} has more than one element {}: write its number, as in '{}.{}'", quoted(above),
                               quoted(word), above, named.front() + 1)};
    return {named.front(), {}};
}

Element element_of(const toml::array& list, std::string_view step, std::string_view above) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), number);
    if (error != std::errc{} || end != step.data() + step.size()) return element_by_word(list, step, above);
    if (number >= 1 && number <= list.size()) return {number - 1, {}};
    return {0, fmt::format("{} has no element {}: its elements are counted from 1 to {}", quoted(above), number,
                           list.size())};
}

std::string no_such_key(const toml::table& table, std::string_view step, std::string_view above) {
    std::vector<std::string_view> keys;
    for (const auto& [key, value] : table)
        keys.push_back(key.str());
    const std::string where = above.empty() ? "the file" : quoted(above);
    return fmt::format("there is no {} in {}: {}", quoted(step), where, remedy(step, keys));
}

/// A step down the path: what stands there, and the list or table that holds it.
struct Spot {
    toml::table* table = nullptr;
    toml::array* list = nullptr;
    std::size_t index = 0;
    std::string_view key{};
    std::string fault{};

    toml::node* node() const { return table != nullptr ? table->get(key) : list->get(index); }
};

Spot spot_in(toml::node& holder, std::string_view step, std::string_view above) {
    if (toml::table* table = holder.as_table()) return {.table = table, .key = step};
    if (toml::array* list = holder.as_array()) {
        Element element = element_of(*list, step, above);
        return {.list = list, .index = element.index, .key = step, .fault = std::move(element.fault)};
    }
    return {.fault = fmt::format("{} is neither a table nor a list: there is nothing in it", quoted(above))};
}

Spot spot_at(toml::table& file, std::string_view path) {
    toml::node* holder = &file;
    for (std::size_t begin = 0;;) {
        const std::size_t dot = path.find('.', begin);
        const std::string_view above = path.substr(0, begin == 0 ? 0 : begin - 1);
        Spot spot = spot_in(*holder, path.substr(begin, dot == path.npos ? dot : dot - begin), above);
        if (dot == path.npos || !spot.fault.empty()) return spot;
        holder = spot.node();
        if (holder == nullptr) return {.fault = no_such_key(*spot.table, spot.key, above)};
        begin = dot + 1;
    }
}

}  // namespace

std::string put_value(toml::table& file, std::string_view path, const toml::node* value) {
    Spot spot = spot_at(file, path);
    if (!spot.fault.empty()) return spot.fault;
    if (value == nullptr) {
        if (spot.table != nullptr) spot.table->erase(spot.key);
        return {};
    }
    value->visit([&spot](const auto& concrete) {
        if (spot.table != nullptr)
            spot.table->insert_or_assign(spot.key, concrete);
        else
            spot.list->replace(spot.list->cbegin() + static_cast<std::ptrdiff_t>(spot.index), concrete);
    });
    return {};
}

const toml::node* value_at(const toml::table& file, std::string_view path) {
    const Spot spot = spot_at(const_cast<toml::table&>(file), path);  // only looked at
    return spot.fault.empty() ? spot.node() : nullptr;
}

std::string written(const toml::node& value) {
    if (const auto text = value.value_exact<std::string_view>()) return std::string(*text);
    std::ostringstream lines;
    lines << toml::json_formatter(value, toml::format_flags::none);
    std::string line;
    bool at_start = false;  // of a line, whose indentation is left out
    for (const char c : std::move(lines).str()) {
        if (c == '\n') line += ' ';
        at_start = c == '\n' || (at_start && c == ' ');
        if (!at_start) line += c;
    }
    return line;
}

}  // namespace mechwright::reading
