#pragma once
/// \file
/// Quick-return drives: everything about them.

#include "analysis/quick_return/assembled.h"     // IWYU pragma: export
#include "analysis/quick_return/crank_shaper.h"  // IWYU pragma: export
#include "analysis/quick_return/drag_link.h"     // IWYU pragma: export
#include "analysis/quick_return/extremes.h"      // IWYU pragma: export
#include "analysis/quick_return/ram.h"           // IWYU pragma: export
#include "analysis/quick_return/rod_swing.h"     // IWYU pragma: export
#include "analysis/quick_return/slide_on_arm.h"  // IWYU pragma: export
#include "analysis/quick_return/whitworth.h"     // IWYU pragma: export
#include "analysis/quick_return/working_part.h"  // IWYU pragma: export
