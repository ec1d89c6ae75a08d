#pragma once
/// \file
/// The motion over which the quantities of a problem are judged, and which of them have a value over it.

#include <cstddef>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// The motion over which the quantities of a problem are judged in a family.
Motion motion_of(const Problem& problem, std::size_t family, std::size_t assembly);

/// That motion as the functions of a quantity get it: over a full turn for one that is over the whole motion, where the
/// family has it.
Motion motion_of(const Problem& problem, const Quantity& quantity, Motion motion);

/// A quantity as it enters programs: where the motion is that over an input range which is not known, the one that
/// knows that its ends move.
const Quantity& programmed_quantity(const Problem& problem, std::size_t quantity);

/// Whether it is one of those.
bool has_moving_ends(const Problem& problem, const Quantity& quantity);

/// Whether a quantity, by its number, has a value in this motion.
bool has_value(const Problem& problem, std::size_t quantity, const Motion& motion);

/// Whether designs with this kind of motion are of use to a problem that is judged over the input range of a target.
bool may_have_family(const Problem& problem, std::size_t family);

}  // namespace mechwright
