#pragma once
/// \file
/// Tables as they are written: the library keeps their keys by name, but in a linkage their order has a meaning.

#include <toml++/toml.h>

#include <string_view>
#include <utility>
#include <vector>

namespace mechwright::reading {

/// The keys of a table and their values in the order of the text.
std::vector<std::pair<std::string_view, const toml::node*>> in_order(const toml::table& table);

}  // namespace mechwright::reading
