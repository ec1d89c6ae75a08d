#pragma once
/// \file
/// The four-bar linkage: everything about it.

#include "analysis/four_bar/cognates.h"          // IWYU pragma: export
#include "analysis/four_bar/coupler_gradient.h"  // IWYU pragma: export
#include "analysis/four_bar/coupler_point.h"     // IWYU pragma: export
#include "analysis/four_bar/four_bar.h"          // IWYU pragma: export
#include "analysis/four_bar/grashof.h"           // IWYU pragma: export
#include "analysis/four_bar/limits.h"            // IWYU pragma: export
#include "analysis/four_bar/pose.h"              // IWYU pragma: export
#include "analysis/four_bar/transmission.h"      // IWYU pragma: export
#include "analysis/four_bar/velocity.h"          // IWYU pragma: export
#include "analysis/four_bar/velocity_ratio.h"    // IWYU pragma: export
