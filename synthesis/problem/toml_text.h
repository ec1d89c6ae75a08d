#pragma once
/// \file
/// From TOML text to a table, or to a message that says in our words why it is not TOML.

#include <toml++/toml.h>

#include <optional>
#include <string_view>

#include "synthesis/problem/messages.h"

namespace mechwright::reading {

std::optional<toml::table> parse_toml(std::string_view text, Messages& messages);

/// Finds what would exhaust the parser's stack or time: dotted keys of very many parts, very many sections. Reports it
/// and returns false.
bool within_parser_limits(std::string_view text, Messages& messages);

/// A TOML syntax error in our words. `place` is where the parser stopped; `description` is what it says.
void report_syntax_error(std::string_view text, Place place, std::string_view description, Messages& messages);

}  // namespace mechwright::reading
