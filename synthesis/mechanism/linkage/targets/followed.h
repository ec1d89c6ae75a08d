#pragma once
/// \file
/// A linkage whose guided point follows a line or an arc over an input range (LinkageModel::followed).

#include <cstddef>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The registry's entry of a line, or an arc, for linkages with so many dimensions.
FollowedShape linkage_line(std::size_t dimensions);
FollowedShape linkage_arc(std::size_t dimensions);

}  // namespace mechwright
