#pragma once
/// \file
/// The error of a function, as it is plotted.

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/report/drawing/finished.h"

namespace mechwright {

/// What the output of a row of the motion is more than the function asks for at a share of the input range.
double function_error(const FinishedDesign& design, const MotionRow& row, double share);

}  // namespace mechwright
