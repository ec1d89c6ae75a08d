#pragma once
/// \file
/// Lists of numbers as documents have them.

#include <nlohmann/json.hpp>
#include <vector>

#include "analysis/geometry/vector.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

/// [[x, y], ...]
nlohmann::ordered_json pairs(const std::vector<Vector<double>>& points);

/// Angles in the unit of the file; null where one is not finite.
nlohmann::ordered_json angles(const std::vector<double>& radians, const Units& units);

}  // namespace mechwright
