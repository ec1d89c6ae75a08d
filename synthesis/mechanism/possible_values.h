#pragma once
/// \file
/// Between which values a quantity lies for every mechanism there can be, whatever its dimensions.

#include <limits>
#include <string_view>

namespace mechwright {

struct PossibleValues {
    double least = -std::numeric_limits<double>::infinity();
    double greatest = std::numeric_limits<double>::infinity();
};

/// Those of a quantity, angles in radians, both ends included. Quantities that are not known here can have any value.
PossibleValues possible_values(std::string_view quantity);

}  // namespace mechwright
