#pragma once
/// \file
/// How a result came about, as it stands in a result document.

#include <nlohmann/json.hpp>

#include "synthesis/problem/problem.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// The method, its proof where it has one, and what it counted.
nlohmann::ordered_json search_document(const Problem& problem, const SearchReport& search);

}  // namespace mechwright
