#pragma once
/// \file
/// The registry entry of the crank shaper, and the parts that it is made of.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

std::shared_ptr<const Mechanism> crank_shaper_mechanism();

/// How its quantities follow from its dimensions, where this is not said of every mechanism alike.
std::vector<QuantityFormula> crank_shaper_formulas();

/// The tasks that `mechwright new` begins with it.
std::vector<Task> crank_shaper_tasks();

/// How it is drawn: turned so that its ram is above the lever's pivot.
Drawing crank_shaper_drawing();

/// Where its dimensions are (drawing/figure.h).
std::vector<FigurePanel> crank_shaper_figure(const std::shared_ptr<const Mechanism>& mechanism);

/// How a file says it as a linkage.
AsLinkage crank_shaper_as_linkage();

}  // namespace mechwright
