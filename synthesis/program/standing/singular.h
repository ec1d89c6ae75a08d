#pragma once
/// \file
/// Designs that stand close to a position in which a linkage can change its way of moving: next to a change point or a
/// toggle, where velocities grow without limit and the errors of manufacture decide how it goes on.

#include <string>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// The rule: a margin of less than this part of the longest length is warned of.
inline constexpr double singular_below = 1e-4;

struct SingularMargin {
    std::string name;         ///< of what nearly happens
    double margin = 0;        ///< a length, in the problem's unit; < 0 where it happens
    double relative = 0;      ///< to the longest length
    bool impossible = false;  ///< by more than rounding: there is no such mechanism, and the name says why
};

/// The margins of a design that are below the rule, each kind once with its least: of the conditions of a crank that
/// turns fully, of the assembly over a given range of crank angles or an input range, and of the positions in which it
/// meets the points of a path. A motion that ends where the linkage does is no reason: its ends are toggles. Nor is a
/// given range over which it does not assemble: that is worse, and told so.
std::vector<SingularMargin> singular_margins(const Problem& problem, const Design& design);

/// "crank turns past ...: 3e-05 mm, 2.1e-07 of the longest length"; of what is impossible its name alone.
std::string to_text(const SingularMargin& margin, const Units& units);

}  // namespace mechwright
