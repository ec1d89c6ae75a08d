#pragma once
/// \file
/// The error of a function, as it is plotted.

#include "synthesis/problem/input_tasks.h"
#include "synthesis/report/drawing/finished.h"

namespace mechwright {

/// What the output is more than a function asks for at a share of the input range.
double function_error(const FinishedDesign& design, const InputTask& task, double share);

}  // namespace mechwright
