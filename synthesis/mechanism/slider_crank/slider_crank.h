#pragma once
/// \file
/// The registry entry of the slider-crank, and the parts that it is made of.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

std::shared_ptr<const Mechanism> slider_crank_mechanism();

/// Whether a mechanism is of the kind.
bool is_slider_crank(const Mechanism& mechanism);

/// How its quantities follow from its dimensions, where this is not said of every mechanism alike.
std::vector<QuantityFormula> slider_crank_formulas();

/// The tasks that `mechwright new` begins with it.
std::vector<Task> slider_crank_tasks();

/// How it is drawn, in the frame of the problem.
Drawing slider_crank_drawing();

/// Where its dimensions are (drawing/figure.h).
std::vector<FigurePanel> slider_crank_figure(const std::shared_ptr<const Mechanism>& mechanism);

/// How a file says it as a linkage.
AsLinkage slider_crank_as_linkage();

}  // namespace mechwright
