#pragma once
/// \file
/// One local search to full precision.

#include "synthesis/local/local.h"

namespace mechwright {

/// The method (for limits on the distances of an untimed path within_limited_distances, where it finds a design), then
/// Newton's polish; where the objective is small against what the program was scaled for, both again
/// in units of what was reached, as long as that pays.
LocalOutcome polished_search(const Program& program, const Eigen::VectorXd& start, LocalMethod method,
                             const LocalLimits& limits);

}  // namespace mechwright
