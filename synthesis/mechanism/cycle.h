#pragma once
/// \file
/// The crank angle after which everything of a mechanism is where it was.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>

#include "synthesis/mechanism/input.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// Whether there is one: a slide that is driven never is where it was by going on.
inline bool comes_round(const Mechanism& mechanism) { return input_unit(mechanism) == Unit::angle; }

/// How many points have an order that counts: a crank that turns on meets two in order either way.
inline std::size_t least_ordered(const Mechanism& mechanism) { return comes_round(mechanism) ? 3 : 2; }

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

/// The cycle in radians; infinite where there is none.
inline double cycle_of(const Mechanism& mechanism) {
    return comes_round(mechanism) ? 2 * std::numbers::pi * turns_of_cycle(mechanism)
                                  : std::numeric_limits<double>::infinity();
}

}  // namespace mechwright
