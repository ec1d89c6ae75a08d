#pragma once
/// \file
/// Where the dimensions of a cam are.

#include "synthesis/mechanism/drawing/figure.h"

namespace mechwright {

std::vector<FigurePanel> cam_figure(const std::shared_ptr<const Mechanism>& cam);

}  // namespace mechwright
