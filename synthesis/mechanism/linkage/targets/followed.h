#pragma once
/// \file
/// A linkage whose guided point follows a line or an arc over an input range (LinkageModel::over_input).

#include <cstddef>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The registry's entry of the line or the arc that is a target of this number, for linkages with so many dimensions.
FollowedShape linkage_shape(const LinkageModel& model, std::size_t over_input, std::size_t dimensions);

}  // namespace mechwright
