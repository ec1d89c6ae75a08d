#pragma once
/// \file
/// Where the dimensions of a four-bar are.

#include "synthesis/mechanism/drawing/figure.h"

namespace mechwright {

std::vector<FigurePanel> four_bar_figure(const std::shared_ptr<const Mechanism>& mechanism);

}  // namespace mechwright
