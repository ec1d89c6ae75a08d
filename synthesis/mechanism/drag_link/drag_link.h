#pragma once
/// \file
/// The registry entry of the drag link, and the parts that it is made of.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

std::shared_ptr<const Mechanism> drag_link_mechanism();

/// How its quantities follow from its dimensions, where this is not said of every mechanism alike.
std::vector<QuantityFormula> drag_link_formulas();

/// The tasks that `mechwright new` begins with it.
std::vector<Task> drag_link_tasks();

/// How it is drawn: in the frame of its slide.
Drawing drag_link_drawing();

/// Where its dimensions are (drawing/figure.h).
std::vector<FigurePanel> drag_link_figure(const std::shared_ptr<const Mechanism>& mechanism);

/// How a file says it as a linkage.
AsLinkage drag_link_as_linkage();

}  // namespace mechwright
