#pragma once
/// \file
/// Fits of whole coupler curves (curve_fit.h).

#include "synthesis/mechanism/curve_fit.h"

namespace mechwright {

/// The curve of the coupler point over the motion in one assembly.
CurveFit four_bar_curve_fit();

}  // namespace mechwright
