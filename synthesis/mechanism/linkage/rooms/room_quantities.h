#pragma once
/// \file
/// What rooms and regions are measured by.

#include <cstddef>
#include <vector>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/quantity.h"

namespace mechwright {

/// NAME.width, NAME.height and NAME.area of each room, NAME.margin of each region; they read the first `dimensions` of
/// the mechanism, of which the model's numbers are sums.
std::vector<Quantity> quantities_of_rooms(const LinkageModel& model, std::size_t dimensions);

}  // namespace mechwright
