#pragma once
/// \file
/// Verification trusts nobody: from the result document alone it rebuilds the design, measures every requirement again
/// over the whole continuous motion in fifty digits, and checks assembly, circuit, branch and order.

#include <nlohmann/json.hpp>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The checks of a document's design, in a fixed order; a document that cannot be understood gives one failed check
/// that says why. Never throws for any JSON value.
std::vector<Check> verify(const nlohmann::ordered_json& document);

}  // namespace mechwright
