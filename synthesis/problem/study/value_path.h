#pragma once
/// \file
/// Values of a problem file by their paths: "require.time-ratio.equal", "dimensions.crank.max", "segment.1.angle".
/// Between the dots stand keys; in a list the number of an element, counted from 1, or what tells it from the others:
/// the quantity of a requirement or an objective, the kind of a segment.

#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace mechwright::reading {

/// Puts a value at a path, in place of what is there, or takes it away where `value` is null. All but the last step of
/// the path must be there. Returns what is wrong with the path, or nothing. The new value has no place in the file.
std::string put_value(toml::table& file, std::string_view path, const toml::node* value);

/// The value at a path; null if there is none.
const toml::node* value_at(const toml::table& file, std::string_view path);

/// A value in one line, as it would be written.
std::string written(const toml::node& value);

}  // namespace mechwright::reading
