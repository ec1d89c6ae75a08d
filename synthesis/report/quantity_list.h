#pragma once
/// \file
/// What the mechanisms' quantities are called in lists of them.

#include <string>
#include <string_view>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// "number", "length", "area", "angle", "force" or "torque".
std::string_view name_of(Unit unit);

/// All that go by this name: cams come in several kinds.
std::vector<const Mechanism*> mechanisms_named(std::string_view name);

/// "unknown mechanism 'x'; ..." with what would be right.
std::string unknown_mechanism(const std::string& name);

}  // namespace mechwright
