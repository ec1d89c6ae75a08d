#pragma once
/// \file
/// Every four-bar that guides a body through up to five poses, or its coupler point through up to five points at given
/// crank angles: both are dyads through poses (Burmester). With five they are isolated, with fewer they form families.

#include <string>

#include "synthesis/exact/family_search.h"

namespace mechwright {

/// Why a problem is not one of up to five poses; empty if it is.
std::string why_no_poses(const Problem& problem);
ExactDesigns pose_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

/// Why a problem is not one of up to five points at given crank angles; empty if it is.
std::string why_no_timed_points(const Problem& problem);
ExactDesigns timed_point_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
