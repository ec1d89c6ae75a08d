#pragma once
/// \file
/// What a document states of the dwells that are to be as still as can be, derived again in fifty digits.

#include <nlohmann/json.hpp>
#include <vector>

#include "synthesis/document/claim.h"

namespace mechwright {

/// Of each dwell in `stated`, the list of a document: that its extremes are where they are stated, that so many of them
/// are as far from the middle as the farthest and alternate, and how many numbers are free and how many limits hold.
/// Where it is stated to be balanced, that weights above 0 of these extremes balance those of the limits. None of a
/// design that comes apart, which other checks say.
std::vector<Check> check_dwells(const nlohmann::ordered_json& stated, const Claim& claim);

}  // namespace mechwright
