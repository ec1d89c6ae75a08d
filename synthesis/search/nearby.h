#pragma once
/// \file
/// The optimum near a design that is known: that of a problem that differs a little.

#include <optional>

#include "synthesis/local/local.h"
#include "synthesis/program/result.h"

namespace mechwright {

struct NearbyOptimum {
    std::optional<Solution> solution;  ///< the best feasible design, if one was found
    bool stationary = false;           ///< it is a local optimum and not only where a search ended
    long evaluations = 0;
};

/// What local searches find from a design of another problem, in all variants of its assembly.
NearbyOptimum nearby(const Problem& problem, const Design& from, const LocalLimits& limits);

/// The local optimum that a search ended near but not at: both local methods in turn, from the design and from close to
/// it, until one ends where the gradient is balanced or none gains any more; no further round begins after so many
/// evaluations. The design itself where it is such an optimum already. The problem has an objective.
NearbyOptimum settled(const Problem& problem, const Design& from, long enough, const LocalLimits& limits);

}  // namespace mechwright
