#pragma once
/// \file
/// The slider-crank: everything about it.

#include "analysis/slider_crank/limits.h"        // IWYU pragma: export
#include "analysis/slider_crank/rod_gradient.h"  // IWYU pragma: export
#include "analysis/slider_crank/rod_point.h"     // IWYU pragma: export
#include "analysis/slider_crank/slider_crank.h"  // IWYU pragma: export
#include "analysis/slider_crank/velocity.h"      // IWYU pragma: export
