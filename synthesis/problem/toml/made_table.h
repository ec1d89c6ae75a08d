#pragma once
/// \file
/// Tables of a problem that are made in memory, with a name for every value, and the text of a file that says the same.

#include <toml++/toml.h>

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "synthesis/problem/messages.h"

namespace mechwright::reading {

struct MadeTable {
    toml::table table;  ///< its keys stand in "lines" that follow each other in the order in which they were given
    NodeNames nodes;
};

/// Precondition: an object in which there is no null.
MadeTable made_table(const nlohmann::ordered_json& object);

/// TOML that reads back as the same table.
std::string text_of(const toml::table& table);

/// The same of a value, on one line, and of a key.
std::string value_text(const toml::node& node);
std::string key_text(std::string_view key);

/// A name one level down, as messages show it: "require" and "min" make "require.min", an index "require[0]".
std::string name_in(const std::string& name, std::string_view key);
std::string name_in(const std::string& name, std::size_t index);

}  // namespace mechwright::reading
