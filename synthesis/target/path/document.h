#pragma once
/// \file
/// What a document says of paths and of poses: what was asked for, and what a design makes of it.

#include <nlohmann/json.hpp>

#include "synthesis/document/claim.h"
#include "synthesis/document/claim_json.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// Adds "path" or "poses", {points, timing, closed, ...}: what was given; with a solution also the points it reaches,
/// at which crank angles and how far from the targets. Angles in the problem's unit. Where targets have names, lists of
/// such members, each with its name and weight.
void put_path(nlohmann::ordered_json& json, const Problem& problem, const Solution* best);

/// Puts what another design has at the points of all paths and poses of a document in the place of what its own has:
/// lists of crank angles and of distances; null: nothing is said of them.
void put_reached(nlohmann::ordered_json& document, const nlohmann::ordered_json* crank_angles,
                 const nlohmann::ordered_json* distances);

namespace claims {

/// Reads the paths and the poses of a document, if there are any.
void read_path(Reader& in, const Json& document, Claim& claim);

}  // namespace claims

}  // namespace mechwright
