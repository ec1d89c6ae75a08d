#pragma once
/// \file
/// The crank angle after which everything of a mechanism is where it was.

#include <algorithm>
#include <numbers>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// In turns of the crank: one, but of linkages that come round after several.
inline int turns_of_cycle(const Mechanism& mechanism) {
    int turns = 1;
    for (const Family& family : mechanism.families)
        turns = std::max(turns, family.turns);
    return turns;
}

/// The same in radians.
inline double cycle_of(const Mechanism& mechanism) { return 2 * std::numbers::pi * turns_of_cycle(mechanism); }

}  // namespace mechwright
