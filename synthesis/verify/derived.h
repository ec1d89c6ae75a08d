#pragma once
/// \file
/// What a document states that follows from its design beside the values of quantities: extremes of an error, and how
/// close the design stands to a singular position.

#include <nlohmann/json.hpp>
#include <vector>

#include "synthesis/document/claim.h"

namespace mechwright {

/// Only those that apply. The extremes of a function or a line are derived anew by the analysis; at each stated place
/// of an expression the error is computed in fifty digits, too.
std::vector<Check> check_derived(const nlohmann::ordered_json& document);

}  // namespace mechwright
