#pragma once
/// \file
/// The designs that a result has beside its own, and the verdict.

#include <nlohmann/json.hpp>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// Every design of a front, in place of the result's own; that none of them is as good as another in both objectives.
/// Every alternative that is not stated with a defect: that it meets the requirements with the objective that is
/// stated, is not better than the result's design, and is the cognate that it is stated to be.
std::vector<Check> check_others(const nlohmann::ordered_json& document);

/// Whether status and stated verification are what the other checks come to where these pass.
std::vector<Check> check_verdict(const nlohmann::ordered_json& document, const std::vector<Check>& checks);

}  // namespace mechwright
