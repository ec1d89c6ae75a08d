#pragma once
/// \file
/// What a document says of a path or of poses: what was asked for, and what a design makes of it.

#include <nlohmann/json.hpp>

#include "synthesis/document/claim.h"
#include "synthesis/document/claim_json.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// {points, timing, closed, ...}: what was given; with a solution also the points it reaches, at which crank angles and
/// how far from the targets. Angles in the problem's unit.
nlohmann::ordered_json path_document(const Problem& problem, const Solution* best);

namespace claims {

/// Reads the path or the poses of a document, if there are any.
void read_path(Reader& in, const Json& document, Claim& claim);

}  // namespace claims

}  // namespace mechwright
