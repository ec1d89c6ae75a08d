#pragma once
/// \file
/// Untimed paths whose points have limits on their distances that are far below the size of the path. Designs within
/// the limits lie next to the surface on which every point is met exactly; squared distances, by which the limits stand
/// in a program, rise steeply on both sides of it, and local methods creep along. What is missed along the normals of
/// the curve is almost linear there.

#include <optional>

#include "synthesis/local/local.h"

namespace mechwright {

/// From a start to close to an optimum of the program, by interior points in terms of the misses along the normals,
/// which are taken anew several times. Nothing where the limits are not that small, or where no feasible design was
/// found.
std::optional<LocalOutcome> within_small_distances(const Program& program, const Eigen::VectorXd& start,
                                                   const LocalLimits& limits);

}  // namespace mechwright
