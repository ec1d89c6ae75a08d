#include "synthesis/problem/toml/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

FilePlace to_place(const toml::source_region& source, const toml::node& node) {
    return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column), &node};
}

bool contains(const std::vector<std::string_view>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// The value of a key if the node is of the type asked for; reports it if it is of another.
template <class T>
std::optional<T> read_value(Section& section, std::string_view key, std::string_view expected, Messages& messages) {
    const toml::node* node = find(section, key);
    if (node == nullptr) return {};
    std::optional<T> value = node->value_exact<T>();
    if (!value) report_kind(*node, name_of(section, key), expected, messages);
    return value;
}

}  // namespace

FilePlace place_of(const toml::node& node) { return to_place(node.source(), node); }

std::string_view kind_of(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::string: return "a string";
        case toml::node_type::integer:
        case toml::node_type::floating_point: return "a number";
        case toml::node_type::boolean: return "true or false";
        case toml::node_type::array: return "a list";
        case toml::node_type::table: return "a table";
        default: return "a date or time";
    }
}

const toml::node* find(Section& section, std::string_view key) {
    assert(section.known.empty() || find_key(section.known, key) != nullptr);
    if (!contains(section.keys, key)) section.keys.push_back(key);
    return section.table->get(key);
}

bool has(const Section& section, std::string_view key) { return section.table->contains(key); }

FilePlace place_of(const Section& section, std::string_view key) {
    const toml::node* node = section.table->get(key);
    return node == nullptr ? section.place : place_of(*node);
}

FilePlace key_place(const Section& section, std::string_view key) {
    const auto entry = section.table->find(key);
    return to_place(entry->first.source(), entry->second);
}

std::string name_of(const Section& section, std::string_view key) {
    return section.title.empty() ? quoted(key) : quoted(key) + " in " + section.title;
}

void report_unknown_keys(const Section& section, Messages& messages) {
    for (const auto& [key, node] : *section.table) {
        if (contains(section.keys, key.str()) || contains(section.reported, key.str())) continue;
        add_error(messages, to_place(key.source(), node),
                  fmt::format("unknown key {}: {}", name_of(section, key.str()), remedy(key.str(), section.keys)));
    }
}

void report_kind(const toml::node& node, std::string_view what, std::string_view expected, Messages& messages) {
    add_error(messages, place_of(node), fmt::format("{} must be {}, not {}", what, expected, kind_of(node)));
}

std::optional<double> to_number(const toml::node& node, std::string_view what, Messages& messages) {
    if (!node.is_number()) {
        report_kind(node, what, "a number", messages);
        return {};
    }
    const double number =
        node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
    if (const std::string_view needed = needed_of(number); !needed.empty()) {
        add_error(messages, place_of(node), fmt::format("{} must be {}, not {}", what, needed, number));
        return {};
    }
    return number;
}

std::optional<double> read_number(Section& section, std::string_view key, Messages& messages) {
    const toml::node* node = find(section, key);
    if (node == nullptr) return {};
    return to_number(*node, name_of(section, key), messages);
}

std::optional<std::int64_t> read_whole_number(Section& section, std::string_view key, Messages& messages) {
    const toml::node* node = find(section, key);
    if (node == nullptr) return {};
    if (node->is_integer()) return node->value<std::int64_t>();
    if (!node->is_floating_point())
        report_kind(*node, name_of(section, key), "a whole number", messages);
    else
        add_error(messages, place_of(*node),
                  fmt::format("{} must be a whole number, written without a decimal point", name_of(section, key)));
    return {};
}

std::optional<bool> read_bool(Section& section, std::string_view key, Messages& messages) {
    return read_value<bool>(section, key, "true or false", messages);
}

std::optional<std::string> read_string(Section& section, std::string_view key, Messages& messages) {
    return read_value<std::string>(section, key, "a string in quotes", messages);
}

std::optional<Section> read_section(Section& parent, std::string_view key, Messages& messages) {
    const toml::node* node = find(parent, key);
    if (node == nullptr) return {};
    const std::string title = fmt::format("[{}]", key);
    if (!node->is_table()) {
        report_kind(*node, quoted(key), fmt::format("a section, headed {}", title), messages);
        return {};
    }
    const Key* known = find_key(parent.known, key);
    return Section{node->as_table(), title, place_of(*node), known == nullptr ? std::span<const Key>() : known->below};
}

std::vector<Section> read_sections(Section& parent, std::string_view key, Messages& messages) {
    std::vector<Section> sections;
    const toml::node* node = find(parent, key);
    const toml::array* list = node == nullptr ? nullptr : node->as_array();
    if (list == nullptr) {
        if (auto section = read_section(parent, key, messages)) sections.push_back(*std::move(section));
        return sections;
    }
    if (list->empty())
        add_error(messages, place_of(*node),
                  fmt::format("{} is empty: leave it out, or head sections [[{}]]", quoted(key), key));
    const Key* known = find_key(parent.known, key);
    const auto keys = known == nullptr ? std::span<const Key>() : known->below;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const toml::node& entry = (*list)[i];
        const std::string title =
            list->size() == 1 ? fmt::format("[[{}]]", key) : fmt::format("[[{}]] number {}", key, i + 1);
        if (entry.is_table())
            sections.push_back(Section{entry.as_table(), title, place_of(entry), keys});
        else
            report_kind(entry, fmt::format("entry {} of {}", i + 1, quoted(key)),
                        fmt::format("a section, headed [[{}]]", key), messages);
    }
    return sections;
}

const toml::table* only_table(const toml::table& file, std::string_view key) {
    const toml::node* node = file.get(key);
    const toml::array* list = node == nullptr ? nullptr : node->as_array();
    if (list != nullptr) node = list->size() == 1 ? list->get(0) : nullptr;
    return node == nullptr ? nullptr : node->as_table();
}

std::optional<std::vector<double>> read_numbers(Section& section, std::string_view key, Messages& messages) {
    const toml::node* node = find(section, key);
    if (node == nullptr) return {};
    if (!node->is_array()) {
        report_kind(*node, name_of(section, key), "a list of numbers", messages);
        return {};
    }
    const toml::array& list = *node->as_array();
    std::vector<double> numbers;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto number = to_number(list[i], fmt::format("number {} of {}", i + 1, name_of(section, key)), messages);
        if (number) numbers.push_back(*number);
    }
    if (numbers.size() < list.size()) return {};
    return numbers;
}

std::optional<std::size_t> to_choice(const toml::node& node, std::string_view what, std::string_view noun,
                                     std::span<const std::string_view> words, Messages& messages) {
    const auto word = node.value_exact<std::string_view>();
    if (!word) {
        report_kind(node, what, "a string in quotes", messages);
        return {};
    }
    const auto at = std::find(words.begin(), words.end(), *word);
    if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
    add_error(messages, place_of(node), fmt::format("unknown {} {}: {}", noun, quoted(*word), remedy(*word, words)));
    return {};
}

std::optional<std::size_t> read_choice(Section& section, std::string_view key, std::string_view noun,
                                       std::span<const std::string_view> words, Messages& messages) {
    const toml::node* node = find(section, key);
    if (node == nullptr) return {};
    return to_choice(*node, name_of(section, key), noun, words, messages);
}

std::optional<std::size_t> read_choice(Section& section, std::string_view key, std::string_view noun,
                                       Messages& messages) {
    return read_choice(section, key, noun, find_key(section.known, key)->words, messages);
}

}  // namespace mechwright::reading
