#pragma once
/// \file
/// The figure of what a problem file describes.

#include <vector>

#include "synthesis/mechanism/drawing/figure.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

/// The panels of a problem's mechanism. Of a linkage it is one, with the numbers that are given, and the starts or the
/// middles of ranges; none where it does not assemble with these.
std::vector<FigurePanel> figure_of(const Problem& problem);

}  // namespace mechwright
