#pragma once
/// \file
/// From TOML text to a table, or to a message that says in our words why it is not TOML.

#include <toml++/toml.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "synthesis/problem/messages.h"

namespace mechwright::reading {

std::optional<toml::table> parse_toml(std::string_view text, Messages& messages);

struct Objection {
    FilePlace place;
    std::string text;
    std::size_t statement;  ///< the bytes before the statement that it is about
};

/// What the parser cannot be trusted with: it would crash, take for ever, or take something for what it is not.
std::optional<Objection> find_objection(std::string_view text);

/// A TOML syntax error in our words. `place` is where the parser stopped; `description` is what it says.
void report_syntax_error(std::string_view text, FilePlace place, std::string_view description, Messages& messages);

}  // namespace mechwright::reading
