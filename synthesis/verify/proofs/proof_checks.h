#pragma once
/// \file
/// Checks of what a result document says to have proven, from the document alone.

#include <nlohmann/json.hpp>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// That the certificate of a complete search shows what it is said to show: that no design is better, or where the
/// document says that there is none, that none meets the requirements. None where nothing is said to be proven.
std::vector<Check> check_proof(const nlohmann::ordered_json& document);

/// Whether a document says that no design meets the requirements, or none was found.
bool says_infeasible(const nlohmann::ordered_json& document);

/// A document of an infeasible problem may show no design: then one at the lower ends of all ranges is put into it, for
/// what is to be read beside it.
nlohmann::ordered_json with_some_design(nlohmann::ordered_json document);

}  // namespace mechwright
