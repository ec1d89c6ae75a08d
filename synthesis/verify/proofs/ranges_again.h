#pragma once
/// \file
/// Whether ranges of dimensions leave room for a mechanism, for verification: in fifty digits, by conditions that each
/// kind of mechanism writes for it (Mechanism::ways_again), not those that designs are made with.

#include "synthesis/verify/proofs/proof_context.h"

namespace mechwright {

/// That no dimensions within the ranges of the document, ties and tolerance among them, make a mechanism that can be
/// put together, or where a full turn of the crank is asked for one whose crank turns fully.
Finding check_ranges_again(const ProofContext& c);

}  // namespace mechwright
