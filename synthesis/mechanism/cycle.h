#pragma once
/// \file
/// The crank angle after which everything of a mechanism is where it was.

#include <algorithm>
#include <numbers>
#include <string>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// In turns of the crank: one, but of linkages that come round after several.
inline int turns_of_cycle(const Mechanism& mechanism) {
    int turns = 1;
    for (const Family& family : mechanism.families)
        turns = std::max(turns, family.turns);
    return turns;
}

/// "one turn", "3 turns".
inline std::string cycle_words(const Mechanism& mechanism) {
    const int turns = turns_of_cycle(mechanism);
    return turns == 1 ? "one turn" : std::to_string(turns) + " turns";
}

/// The cycle in radians.
inline double cycle_of(const Mechanism& mechanism) { return 2 * std::numbers::pi * turns_of_cycle(mechanism); }

}  // namespace mechwright
