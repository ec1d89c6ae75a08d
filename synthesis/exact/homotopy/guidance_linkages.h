#pragma once
/// \file
/// The linkages that a solution of a guidance system stands for.

#include <optional>
#include <vector>

#include "synthesis/exact/guided_parts.h"
#include "synthesis/exact/homotopy/guidance_solutions.h"
#include "synthesis/exact/poses/guided_linkage.h"

namespace mechwright::homotopy {

/// A solution with its dyads both ways round; of points alone its two cognates too. One with a ram of
/// points alone with its cognate; others with a ram or block alone.
std::vector<GuidanceValues> orbit_members(const GuidanceSystem& system, const GuidanceValues& solution);

/// How the body has moved at each of the target's places, in their order, by a real solution.
std::vector<Displacement> displacements_of(const GuidanceValues& solution, const GuidanceTarget& target);

/// Where the target is in the drawing.
DrawingPlace place_of(const GuidanceTarget& target);

/// What a real solution consists of.
GuidedParts parts_of(const GuidanceValues& solution, const GuidanceSystem& system);

/// The four-bar of a real solution of the target; nothing where a link has no length.
std::optional<GuidedLinkage> linkage_of(const GuidanceValues& solution, const GuidanceTarget& target);

}  // namespace mechwright::homotopy
