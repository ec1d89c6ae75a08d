#pragma once
/// \file
/// The registry entry of Whitworth's drive, and the parts that it is made of.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

std::shared_ptr<const Mechanism> whitworth_mechanism();

/// How its quantities follow from its dimensions, where this is not said of every mechanism alike.
std::vector<QuantityFormula> whitworth_formulas();

/// The tasks that `mechwright new` begins with it.
std::vector<Task> whitworth_tasks();

/// How it is drawn: in the frame of its slide.
Drawing whitworth_drawing();

/// Where its dimensions are (drawing/figure.h).
std::vector<FigurePanel> whitworth_figure(const std::shared_ptr<const Mechanism>& mechanism);

/// How a file says it as a linkage.
AsLinkage whitworth_as_linkage();

}  // namespace mechwright
