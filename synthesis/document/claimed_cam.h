#pragma once
/// \file
/// The motion of a cam that a result document claims.

#include "synthesis/document/claim.h"
#include "synthesis/document/claim_json.h"

namespace mechwright::claims {

/// Makes a claim of a cam one of the cam's follower, with its motion program and the assembly (rotation) of its design.
/// Each segment has the one law that was chosen.
void read_cam(Reader& in, const Json& document, Claim& claim);

}  // namespace mechwright::claims
