#pragma once
/// \file
/// What a result document says of a cam beside its dimensions.

#include "synthesis/document/kinds_in_documents.h"

namespace mechwright {

/// cam: {follower, motion, [contour], segments: [{kind, [laws], [start, end, shape], [points]}]}, what was given.
/// start, end and shape count the numbers of a polynomial, points are [cam angle, lift]. Of a design rotation and laws,
/// one name for each segment, empty where it has none.
KindInDocuments cam_in_documents();

namespace claims {

/// Makes a claim of a cam one of the cam's follower, with its motion program and the assembly (rotation) of its design.
/// Each segment has the one law that was chosen.
void read_cam(Reader& in, const Json& document, Claim& claim);

}  // namespace claims

}  // namespace mechwright
