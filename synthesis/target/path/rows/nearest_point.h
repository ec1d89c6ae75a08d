#pragma once
/// \file
/// The crank angles of a design at its targets: prescribed ones, and those of the points of a guided curve nearest to
/// the targets of a path without timing.

#include "synthesis/mechanism/sure_part.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// Sets the crank angles at the points of a timed path: each is counted from the start of its target.
void set_prescribed_angles(const Problem& problem, Design& design);

/// Sets the crank angle of each target to that of the nearest point of the whole curve, as far as it is sure: the best
/// of all local minima of the distance, each bracketed between samples and located to rounding. Angles stay as they are
/// where the mechanism assembles nowhere.
void meet_nearest_points(const Problem& problem, Design& design);

}  // namespace mechwright
