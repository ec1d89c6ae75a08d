#pragma once
/// \file
/// The registry entry of the four-bar linkage.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

const Mechanism& four_bar_mechanism();

}  // namespace mechwright
