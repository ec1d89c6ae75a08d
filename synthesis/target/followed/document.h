#pragma once
/// \file
/// What is said of a line or an arc that a guided point follows beside the design.

#include <nlohmann/json.hpp>

#include "synthesis/document/claim.h"
#include "synthesis/document/claim_json.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// {full_turn}; with a design also extremes: [{crank_angle, distance}], `alternating` and `free` as for a function.
nlohmann::ordered_json followed_document(const Problem& problem, const Design* design);

namespace claims {

/// Reads the line or the arc of a document, if there is one.
void read_followed(Reader& in, const Json& document, Claim& claim);

}  // namespace claims

}  // namespace mechwright
