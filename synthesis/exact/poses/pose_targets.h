#pragma once
/// \file
/// Poses, or points at given crank angles, as displacements from the first.

#include <vector>

#include "synthesis/exact/poses/certified_dyad.h"
#include "synthesis/exact/poses/dyad_family.h"
#include "synthesis/exact/poses/guided_linkage.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

/// Lengths are scaled to about 1.
struct PoseTargets {
    const Problem* problem;
    DrawingPlace place;
    std::vector<Displacement> displacements;  ///< turns of the body; for timed points of the crank

    std::size_t places() const { return displacements.size() + 1; }
};

PoseTargets pose_targets(const Problem& problem);

/// The same with other directions (radians) at the points of the problem.
PoseTargets pose_targets(const Problem& problem, const std::vector<double>& directions);

/// The displacements in fifty digits.
std::vector<ExactDisplacement> exact_displacements(const PoseTargets& targets);

/// Ranges of the crank's pivot.
PivotRanges crank_pivot_ranges(const PoseTargets& targets);

}  // namespace mechwright
