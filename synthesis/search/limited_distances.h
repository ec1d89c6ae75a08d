#pragma once
/// \file
/// Untimed paths with a limit on the distances of their points. Where the limit is far below the size of the path,
/// designs within it lie next to the surface on which every point is met exactly; squared distances, by which it stands
/// in a program, rise steeply on both sides of it, and local methods creep along. What is missed along the normals of
/// the curve is almost linear there.

#include <optional>

#include "synthesis/local/local.h"

namespace mechwright {

/// From a start to close to an optimum of the program, by interior points in terms of the misses along the normals,
/// which are taken anew several times. Nothing where there is no such limit, or where no feasible design was found.
/// Methods that go on from there have this way in common.
std::optional<LocalOutcome> within_limited_distances(const Program& program, const Eigen::VectorXd& start,
                                                     const LocalLimits& limits);

}  // namespace mechwright
