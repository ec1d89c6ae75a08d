#pragma once
/// \file
/// Typed access to the tables of a problem file. What is of the wrong kind is reported where it stands and counts as
/// absent; `has` tells what is absent in truth. A section remembers the keys it was asked for: those are the keys it
/// may hold.

#include <toml++/toml.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/messages.h"
#include "synthesis/problem/schema/key.h"

namespace mechwright::reading {

struct Section {
    const toml::table* table = nullptr;
    std::string title;  ///< as messages name it: "[path]"
    FilePlace place;
    std::span<const Key> known{};              ///< every key that it can have; empty where the mechanism says that
    std::vector<std::string_view> keys{};      ///< asked for so far
    std::vector<std::string_view> reported{};  ///< keys that are wrong here and have been reported as such
};

FilePlace place_of(const toml::node& node);

/// "a number", "a string", "a list", ...
std::string_view kind_of(const toml::node& node);

/// The value of a key, or null. The name must outlive the section.
const toml::node* find(Section& section, std::string_view key);

bool has(const Section& section, std::string_view key);

/// Where the key itself stands. The section must have it.
FilePlace key_place(const Section& section, std::string_view key);

/// Where the value of a key stands; if there is none, where the section does.
FilePlace place_of(const Section& section, std::string_view key);

/// "'key' in [section]"
std::string name_of(const Section& section, std::string_view key);

/// Reports every other key, with the nearest one that was asked for.
void report_unknown_keys(const Section& section, Messages& messages);

/// "... must be a number, not a string"
void report_kind(const toml::node& node, std::string_view what, std::string_view expected, Messages& messages);

std::optional<double> to_number(const toml::node& node, std::string_view what, Messages& messages);

std::optional<double> read_number(Section& section, std::string_view key, Messages& messages);
std::optional<std::int64_t> read_whole_number(Section& section, std::string_view key, Messages& messages);
std::optional<bool> read_bool(Section& section, std::string_view key, Messages& messages);
std::optional<std::string> read_string(Section& section, std::string_view key, Messages& messages);
std::optional<Section> read_section(Section& parent, std::string_view key, Messages& messages);
/// The tables of a section that may be repeated: one, headed [key], or a list of them, each headed [[key]].
std::vector<Section> read_sections(Section& parent, std::string_view key, Messages& messages);
/// The only one of them; null where there is none or are several.
const toml::table* only_table(const toml::table& file, std::string_view key);

/// A list of numbers; absent if any of them is none.
std::optional<std::vector<double>> read_numbers(Section& section, std::string_view key, Messages& messages);

/// One of some words: its index. `noun` is what they are ("timing").
std::optional<std::size_t> to_choice(const toml::node& node, std::string_view what, std::string_view noun,
                                     std::span<const std::string_view> words, Messages& messages);
std::optional<std::size_t> read_choice(Section& section, std::string_view key, std::string_view noun,
                                       std::span<const std::string_view> words, Messages& messages);
/// One of the words that the key is known to have.
std::optional<std::size_t> read_choice(Section& section, std::string_view key, std::string_view noun,
                                       Messages& messages);

}  // namespace mechwright::reading
