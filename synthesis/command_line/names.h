#pragma once
/// \file
/// What the commands that list and explain call things.

#include <string_view>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// "number", "length", "area", "angle", "force" or "torque".
std::string_view name_of(Unit unit);

/// The names of all mechanisms, each once.
std::vector<std::string_view> mechanism_names();

/// What `mechwright explain` knows: quantities, dimensions, settings and mechanisms, each name once.
std::vector<std::string_view> explained_names();

}  // namespace mechwright
