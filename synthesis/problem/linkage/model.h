#pragma once
/// \file
/// What a linkage's file says as the model of a mechanism: its dimensions, their ranges, and what is made of them.
/// Lengths are those of the file, angles radians.

#include <cstddef>
#include <vector>

#include "synthesis/problem/linkage/linkage.h"

namespace mechwright {

/// The dimensions of the mechanism of a linkage: those of its links that follow no other, and those of its placement.
std::vector<Dimension> dimensions_of(const Linkage& linkage);

/// The ranges of these dimensions.
std::vector<DimensionRange> ranges_of(const Linkage& linkage);

/// What the mechanism is made of but the sides of its assemblies, starts of larger groups and the turns of its cycle.
LinkageModel model_of(const Linkage& linkage);

/// The margin of the dyad that is closed at a pin; linkage::none where none is.
std::size_t margin_at(const Linkage& linkage, std::size_t pin);

}  // namespace mechwright
