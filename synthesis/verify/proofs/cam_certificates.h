#pragma once
/// \file
/// Checks of certificates of the least size of a cam: weighted half-planes under a roller, a place under a flat face.

#include "synthesis/verify/proofs/proof_context.h"

namespace mechwright {

/// That the certificate excludes every cam that is smaller than the design, or every one that is allowed.
Finding check_half_planes(const ProofContext& c);
Finding check_curvature(const ProofContext& c);

}  // namespace mechwright
