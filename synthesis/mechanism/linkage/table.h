#pragma once
/// \file
/// The motion of a linkage as a table.

#include <string_view>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// Columns: the input of the master (`crank-angle`; `input-angle` where a link "crank" has another angle; where a slide
/// is driven `displacement`, before `scale`); `LINK-angle` of every other link that moves, against the x axis of the
/// frame, in (-pi, pi]; `POINT-x` and `POINT-y` of every point, in the drawing; `NAME-displacement` of every slide, or
/// `slide-1-displacement` by its number, after `scale`; then every signal under its name, angles counted on from the
/// start of the motion. Links and points that circular slots stand for are left out, and columns whose name a signal
/// has.
MotionTable linkage_table(const LinkageModel& model);

}  // namespace mechwright
