#pragma once
/// \file
/// The four-bars that a solution of a guidance system stands for.

#include <optional>
#include <vector>

#include "synthesis/exact/homotopy/guidance_solutions.h"
#include "synthesis/exact/poses/guided_linkage.h"

namespace mechwright::homotopy {

/// A solution with its dyads both ways round; of points alone its two cognates too.
std::vector<GuidanceValues> orbit_members(const GuidanceSystem& system, const GuidanceValues& solution);

/// The four-bar of a real solution of the target; nothing where a link has no length.
std::optional<GuidedLinkage> linkage_of(const GuidanceValues& solution, const GuidanceTarget& target);

}  // namespace mechwright::homotopy
