#pragma once
/// \file
/// Slider-cranks whose rod guides a body through up to four poses: its ram is a point of the body whose places lie on a
/// line, in four poses the only one there is (Ball's point); its crank is a dyad. An inverted slider-crank is the same
/// seen from the body: a fixed point whose places on the body lie on a line of it.

#include <string>

#include "synthesis/exact/family_search.h"
#include "synthesis/exact/guided_parts.h"
#include "synthesis/exact/poses/pose_targets.h"

namespace mechwright {

/// The slider-crank of a crank and a ram, with the displacements of all places in their order from that in which both
/// are given; nothing where a link has no length.
std::optional<ExactDesign> slider_crank_design(const Problem& problem, const DrawingPlace& place, const Dyad& crank,
                                               const SliderDyad& ram, std::span<const Displacement> displacements);

/// How many numbers choose a slider-crank through so many poses, 2 to 4, and the best of those that they choose.
inline std::size_t numbers_of_slider_crank(std::size_t poses) {
    return numbers_of_dyad(poses) + numbers_of_slider(poses);
}
std::optional<ExactDesign> slider_crank_of_poses(const PoseTargets& targets, std::span<const double> numbers);

/// Why a problem is not one of these; empty if it is.
std::string why_no_slider_crank_poses(const Problem& problem);
ExactDesigns slider_crank_pose_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
