#pragma once
/// \file
/// Which of many designs of a linkage assemble, eight side by side: what it takes to place a guided point
/// (GuidedPoint::needed) in lanes.

#include <span>

#include "analysis/numbers/instruction_set.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// Whether a mechanism is a linkage whose guided points close in dyads.
bool has_margins_in_lanes(const Mechanism& mechanism);

/// The least margins of eight designs of such a linkage, `arguments` as of PointGuidance::miss, each at a crank angle
/// of its own: less than 0 where one does not assemble there, with the bits that `miss` says; not a number where this
/// does not tell. Lengths before `scale`.
Group margins_in_lanes(InstructionSet set, Form form, std::span<const Group> arguments, const Group& crank_angles);

}  // namespace mechwright
