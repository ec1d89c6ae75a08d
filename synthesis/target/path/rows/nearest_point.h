#pragma once
/// \file
/// The crank angles of a design at its targets: prescribed ones, and those of the points of a guided curve nearest to
/// the targets of a path without timing.

#include "synthesis/program/result.h"

namespace mechwright {

/// Sets the crank angles at the points of a timed path: each is counted from the start of its target.
void set_prescribed_angles(const Problem& problem, Design& design);

/// Where a mechanism assembles by less than this part of its longest length the end of its motion and rounding decide
/// where its point is: at such a place nobody can say how far it is from a target that is met at any time.
inline constexpr double sure_part = 1e-10;

/// Sets the crank angle of each target to that of the nearest point of the whole curve, as far as it is sure: the best
/// of all local minima of the distance, each bracketed between samples and located to rounding. Angles stay as they are
/// where the mechanism assembles nowhere.
void meet_nearest_points(const Problem& problem, Design& design);

}  // namespace mechwright
