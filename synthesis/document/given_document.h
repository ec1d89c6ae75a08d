#pragma once
/// \file
/// What a problem file gives, as it stands in a result document: in the units of the file.

#include <nlohmann/json.hpp>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// The dimensions that it names: a number, a range, choices or a tie each.
nlohmann::ordered_json given_dimensions(const Problem& problem);

/// The units of its numbers.
nlohmann::ordered_json units_document(const Units& units);

/// The range of use, which it has to give.
nlohmann::ordered_json given_range_of_use(const Problem& problem);

}  // namespace mechwright
