#pragma once
/// \file
/// How the quantities of a four-bar follow from its dimensions, where this is not said of every mechanism.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

std::vector<QuantityFormula> four_bar_formulas();

}  // namespace mechwright
