#pragma once
/// \file
/// At which inputs a design that is driven in any way meets its targets, from its own motion.

#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// Lists of crank angles, or displacements of the slide that drives, at which the point or body that is guided meets
/// the targets of a problem one after the other within one cycle of the drive: with a rising input, with a falling one,
/// the shortest way of each; none where it does not meet them in their order. Of a point and a pose in which a linkage
/// is twice in a cycle both instants count. They are told apart where they are farther apart than a 720th of the
/// motion.
std::vector<std::vector<double>> inputs_in_order(const Problem& problem, const Design& design);

}  // namespace mechwright
