#pragma once
/// \file
/// Every four-bar that guides a body through up to five poses, or its coupler point through up to five points at given
/// crank angles: both are dyads through poses (Burmester). With five they are isolated, with fewer they form families.

#include <string>

#include "synthesis/exact/family_search.h"
#include "synthesis/exact/guided_parts.h"
#include "synthesis/exact/poses/pose_targets.h"

namespace mechwright {

/// Why a problem is not one of up to five poses; empty if it is.
std::string why_no_poses(const Problem& problem);
ExactDesigns pose_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

/// The best four-bar through poses whose dyads the numbers choose, twice as many as a dyad has.
std::optional<ExactDesign> member_of_poses(const PoseTargets& targets, std::span<const double> numbers);

/// Why a problem is not one of up to five points at given crank angles; empty if it is.
std::string why_no_timed_points(const Problem& problem);
ExactDesigns timed_point_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
