#pragma once
/// \file
/// Targets that are met exactly by a family of designs: which of it is the most compact.

#include <cstddef>
#include <optional>

#include "synthesis/local/local.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// How many numbers of a design that meets a path or poses exactly can still be chosen, to first order and limits
/// aside: its free dimensions less the rank of what the targets, and values that are required, say of them. 0 where the
/// design is alone.
std::size_t free_numbers(const Problem& problem, const Design& design);

/// The problem that asks for the least total length of the family that a design is of: the error may be a little more
/// than nothing, so that there is room to search in. Nothing where the mechanism has no total length.
std::optional<Problem> along_family(const Problem& problem, const Design& design);

/// A design of that problem put onto the targets of the first by least squares; `evaluations` is added to.
Solution met_exactly(const Problem& problem, const Design& design, const LocalLimits& limits, long& evaluations);

}  // namespace mechwright
