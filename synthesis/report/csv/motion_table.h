#pragma once
/// \file
/// The motion of a design as a table for other programs.

#include <string>

#include "synthesis/report/drawing/finished.h"

namespace mechwright {

/// Comma-separated values: a line of column names with units ("rocker-angle [deg]"), then one line at each end of the
/// motion and at `steps` - 1 crank angles evenly between them, as far as the mechanism assembles there. Numbers are the
/// shortest that read back as the same, with a point, whatever the locale.
std::string motion_table(const Problem& problem, const Design& design, int steps);
std::string motion_table(const FinishedDesign& design, int steps);

/// Its first line alone: what there is to say of a design that was not found.
std::string motion_header(const Problem& problem);

}  // namespace mechwright
