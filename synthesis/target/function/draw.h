#pragma once
/// \file
/// The error of a function, as it is plotted.

#include "synthesis/report/drawing/finished.h"

namespace mechwright {

/// What the output is more than the function asks for at a share of the input range.
double function_error(const FinishedDesign& design, double share);

}  // namespace mechwright
