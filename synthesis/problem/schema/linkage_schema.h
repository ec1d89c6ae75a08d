#pragma once
/// \file
/// What the schema of problem files says of linkages beside the lists of keys.

#include <array>
#include <string_view>

#include "synthesis/problem/schema/json_schema.h"

namespace mechwright::schema {

/// Sections that describe a linkage.
inline constexpr std::array<std::string_view, 10> sections_of_linkage{
    "links", "slide", "slot", "gear", "belt", "rack", "drive", "assembly", "sketch", "placement"};

/// One drive, or several.
Json drives(const Key& key);

/// What files of a linkage can say and have to.
Json of_linkage();

/// Whether a file is of a mechanism of this name.
Json is_named(std::string_view name);

}  // namespace mechwright::schema
