#pragma once
/// \file
/// Slider-cranks whose rod guides a body through up to four poses: its ram is a point of the body whose places lie on a
/// line, in four poses the only one there is (Ball's point); its crank is a dyad.

#include <string>

#include "synthesis/exact/family_search.h"

namespace mechwright {

/// Why a problem is not one of these; empty if it is.
std::string why_no_slider_crank_poses(const Problem& problem);
ExactDesigns slider_crank_pose_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
