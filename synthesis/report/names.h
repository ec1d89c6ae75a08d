#pragma once
/// \file
/// The names that lists and explanations go by.

#include <string>
#include <string_view>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// "number", "length", "area", "curvature", "angle", "force" or "torque".
std::string_view name_of(Unit unit);

/// The names of all mechanisms, each once.
std::vector<std::string_view> mechanism_names();

/// All that go by this name: cams come in several kinds.
std::vector<std::shared_ptr<const Mechanism>> mechanisms_named(std::string_view name);

/// "unknown mechanism 'x'; ..." with what would be right.
std::string unknown_mechanism(const std::string& name);

/// What `mechwright explain` knows: quantities, dimensions, settings and mechanisms, each name once.
std::vector<std::string_view> explained_names();

}  // namespace mechwright
