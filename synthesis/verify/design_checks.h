#pragma once
/// \file
/// Whether a design is the mechanism that a document states, with the dimensions that were asked for, and moves as far
/// as it can.

#include "synthesis/verify/rebuilt.h"

namespace mechwright {

/// That what was given is as given, and the rest within its ranges.
Check check_ranges(const Claim& claim);

/// That it is of the kind that is stated, which it has to be.
Check check_kind(const Rebuilt& design);

/// That the motion is the circuit and the branch that are stated, as both are numbered.
Check check_circuit(const Rebuilt& design);

/// Whether quantities are measured over the motion of the linkage itself, which ends where it cannot go on.
bool ends_by_itself(const Rebuilt& design);

/// A motion that ends by itself, made longer by a little, comes apart: nothing of it is left out.
Check check_whole_motion(const Rebuilt& design);

}  // namespace mechwright
