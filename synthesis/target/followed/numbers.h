#pragma once
/// \file
/// The numbers of a line or an arc that a guided point follows, as a mechanism's dimensions.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// Those of a shape of the mechanism, after the input range.
void add_shape(Mechanism& mechanism, FollowedShape& shape);

}  // namespace mechwright
