#pragma once
/// \file
/// Several paths and poses of a problem as parts of one path.

#include <string>
#include <string_view>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// Adds a path or poses, as they would stand alone, to others that have the same timing. Its points get such weights
/// that over all points together the mean square is that of the parts, each with its weight:
/// rms = sqrt(sum weight rms^2 / sum weight).
void add_part(PathTarget& whole, PathTarget alone, std::string name, double weight);

/// "point 3"; where paths and poses have names "point 3 of 'foot'".
std::string point_name(const PathTarget& path, std::size_t point);

/// "free", "prescribed" or "none", as files and documents have it.
std::string_view timing_word(const PathTarget& path);

}  // namespace mechwright
