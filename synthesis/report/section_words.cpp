#include "synthesis/report/section_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "synthesis/problem/schema/keys.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

/// A table of a file with the path that leads to it.
struct FileTable {
    std::string path;
    const Key* key;

    std::string in_file() const {
        return key->shape == Shape::tables ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
    }
};

void add_below(const std::string& path, std::span<const Key> keys, std::vector<FileTable>& all) {
    for (const Key& key : keys) {
        if (key.below.empty()) continue;
        const std::string below = path.empty() ? std::string(key.name) : fmt::format("{}.{}", path, key.name);
        all.push_back({below, &key});
        add_below(below, key.below, all);
    }
}

std::vector<FileTable> all_sections() {
    std::vector<FileTable> all;
    add_below("", keys::of_file(), all);
    return all;
}

std::string number_words(std::string_view noun, const Limits& limits) {
    const bool below = std::isfinite(limits.most), above = std::isfinite(limits.least);
    if (above && below)
        return fmt::format("{} {} {:g} {} {:g}", noun, limits.above ? "above" : "from", limits.least,
                           limits.below ? "and below" : "to", limits.most);
    if (below) return fmt::format("{} {} {:g}", noun, limits.below ? "below" : "up to", limits.most);
    if (above) return fmt::format("{} {} {:g}", noun, limits.above ? "above" : "from", limits.least);
    return std::string(noun);
}

std::string either_of(std::span<const std::string_view> words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 == words.size() ? " or " : ", ", words[i]);
    return text;
}

/// What stands behind a key.
std::string value_words(const Key& key) {
    switch (key.shape) {
        case Shape::number: return number_words("number", key.limits);
        case Shape::whole_number: return number_words("whole number", key.limits);
        case Shape::flag: return "true or false";
        case Shape::text: return "text";
        case Shape::word: return either_of(key.words);
        case Shape::word_list: return either_of(key.words) + ", or a list of them";
        case Shape::texts: return "list of texts";
        case Shape::name: return "name";
        case Shape::names: return "table of names";
        case Shape::numbers: return "list of numbers";
        case Shape::open_numbers: return "list of numbers or null";
        case Shape::ends: return "[from, to]";
        case Shape::pairs: return "[[x, y], ...]";
        case Shape::poses: return "[[x, y, angle], ...]";
        case Shape::range: return "number or { min, max }";
        case Shape::tied_range:
        case Shape::range_or_sum: return "number, { min, max } or sum of dimensions";
        case Shape::ranges: return "list of numbers or { min, max }";
        case Shape::expression: return "number or sum of dimensions";
        case Shape::place: return "point, [x, y] or { length, angle }";
        case Shape::table: return "table";
        case Shape::tables: return "repeated table";
        case Shape::value: return key.words.empty() ? "as said" : either_of(key.words) + ", or as said";
    }
    return "";
}

std::string meaning_of(const Key& key) {
    return fmt::format("{}{}: {}", value_words(key), key.required ? ", needed" : "", key.meaning);
}

std::string as_section(const FileTable& section, bool colour) {
    std::size_t widest = 0;
    for (const Key& key : section.key->below)
        widest = std::max(widest, key.name.size());
    std::string text = emphasised(section.in_file(), Emphasis::strong, colour) + ": section of a problem file\n\n" +
                       folded("", section.key->meaning) + "\n";
    for (const Key& key : section.key->below)
        text += folded(fmt::format("  {:<{}}", key.name, widest + 2), meaning_of(key));
    return text;
}

/// A key by its name alone, wherever it stands, or by its section and its name.
std::string as_key(std::string_view name, bool colour) {
    const std::size_t dot = name.rfind('.');
    const std::string_view alone = dot == std::string_view::npos ? name : name.substr(dot + 1);
    std::string text;
    const auto add = [&](const std::string& where, const Key& key) {
        if (text.empty()) text = emphasised(alone, Emphasis::strong, colour) + ": key of a problem file\n\n";
        text += folded(fmt::format("  {:<18}", where), meaning_of(key));
    };
    if (const Key* key = find_key(keys::of_file(), name); key != nullptr && key->below.empty()) add("the file", *key);
    for (const FileTable& section : all_sections())
        if (const Key* key = find_key(section.key->below, alone);
            key != nullptr && (dot == std::string_view::npos || section.path == name.substr(0, dot)))
            add("in " + section.in_file() + " ", *key);
    return text;
}

std::string in_markdown(std::string_view text) {
    std::string escaped;
    for (const char c : text)
        escaped += c == '|' ? "\\|" : std::string(1, c);
    return escaped;
}

void add_table(std::span<const Key> keys, std::string& text) {
    text += "\n| key | value | meaning |\n| --- | --- | --- |\n";
    for (const Key& key : keys)
        text += fmt::format("| `{}`{} | {} | {} |\n", key.name, key.required ? " (needed)" : "",
                            in_markdown(value_words(key)), in_markdown(key.meaning));
}

}  // namespace

std::vector<std::string> section_names() {
    std::vector<std::string> names;
    const auto add = [&](std::string name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
    };
    for (const Key& key : keys::of_file())
        add(std::string(key.name));
    for (const FileTable& section : all_sections()) {
        add(section.path);
        for (const Key& key : section.key->below)
            add(std::string(key.name));
    }
    return names;
}

std::string explained_section(std::string_view name, bool colour) {
    std::string text;
    for (const FileTable& section : all_sections())
        if (section.path == name) text += as_section(section, colour);
    if (const std::string key = as_key(name, colour); !key.empty()) text += (text.empty() ? "" : "\n") + key;
    return text;
}

std::string sections_as_markdown() {
    std::vector<Key> plain;
    for (const Key& key : keys::of_file())
        if (key.below.empty()) plain.push_back(key);
    std::string text = "### The file\n\nWhat has no keys of its own.\n";
    add_table(plain, text);
    for (const FileTable& section : all_sections()) {
        text += fmt::format("\n### {}\n\n{}\n", section.in_file(), section.key->meaning);
        add_table(section.key->below, text);
    }
    return text;
}

}  // namespace mechwright
