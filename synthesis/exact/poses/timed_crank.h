#pragma once
/// \file
/// The cranks of points at given crank angles.

#include <optional>
#include <vector>

#include "synthesis/exact/poses/pose_targets.h"

namespace mechwright {

/// The crank of timed points seen from the other end of the coupler: a dyad whose moving pivot is the crank pin,
/// turned by half a turn, and whose link runs from the pin to the point. This is the crank's own dyad, and how the
/// coupler turns with it.
struct TimedCrank {
    Dyad dyad;
    std::vector<Displacement> displacements;
};

/// From that dyad, whose body turns as the crank does.
TimedCrank timed_crank(const PoseTargets& targets, const Dyad& seen);

/// Where the crank's start and the ground link's direction are given, or that of the slide, the crank pin's direction
/// is.
std::optional<DyadCondition> line_of_crank_pin(const PoseTargets& targets);

}  // namespace mechwright
