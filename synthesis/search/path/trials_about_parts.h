#pragma once
/// \file
/// Searches of a linkage for a path from four-bars among its links that follow the path by themselves (known_parts.h).

#include <vector>

#include "synthesis/search/path/path_rounds.h"

namespace mechwright {

/// The best of these searches, feasible ones first, to be looked at closely; they, and the searches for the four-bars,
/// take about so many evaluations at most, which the report of `rounds` counts: once there were so many nothing is
/// begun, but what has begun, the searches near the best, goes to its end. None where the linkage has no such part, or
/// least squares do not lead to the objective. The drawn starts of rounds stay what they are.
std::vector<Trial> trials_about_parts(PathRounds& rounds, long budget);

}  // namespace mechwright
