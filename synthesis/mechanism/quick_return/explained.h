#pragma once
/// \file
/// How the quantities of mechanisms that drive a ram follow from their dimensions, where this is not said of every one.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

std::vector<QuantityFormula> slider_crank_formulas();
std::vector<QuantityFormula> crank_shaper_formulas();
std::vector<QuantityFormula> whitworth_formulas();
std::vector<QuantityFormula> drag_link_formulas();

}  // namespace mechwright
