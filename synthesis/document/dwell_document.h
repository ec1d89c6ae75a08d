#pragma once
/// \file
/// Dwells that are to be as still as can be, as members of a document.

#include <nlohmann/json.hpp>

#include "synthesis/program/result.h"

namespace mechwright {

/// Adds them to what is said of a design, where there are any.
void put_dwells(nlohmann::ordered_json& json, const Problem& problem, const Design& design);

}  // namespace mechwright
