#pragma once
/// \file
/// Numbers and lists of them as documents have them.

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "analysis/geometry/vector.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

/// A member of an object; numbers that are not finite are never written.
void put_number(nlohmann::ordered_json& object, std::string_view name, double number);

/// [[x, y], ...]
nlohmann::ordered_json pairs(const std::vector<Vector<double>>& points);

/// Numbers of a unit in that of the file; null where one is not finite.
nlohmann::ordered_json in_file_units(const std::vector<double>& values, Unit unit, const Units& units);

/// Angles in the unit of the file; null where one is not finite.
nlohmann::ordered_json angles(const std::vector<double>& radians, const Units& units);

}  // namespace mechwright
