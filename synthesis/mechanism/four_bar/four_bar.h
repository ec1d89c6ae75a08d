#pragma once
/// \file
/// The registry entry of the four-bar linkage.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

std::shared_ptr<const Mechanism> four_bar_mechanism();

/// Whether a mechanism is a four-bar.
bool is_four_bar(const Mechanism& mechanism);

}  // namespace mechwright
