#pragma once
/// \file
/// The motion of a design as a table for other programs.

#include <span>
#include <string>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// Comma-separated values: a line of column names with units ("rocker-angle [deg]"), then one line at each end of the
/// motion and at `steps` - 1 crank angles evenly between them, as far as the mechanism assembles there. Numbers are the
/// shortest that read back as the same, with a point, whatever the locale.
std::string motion_table(const Problem& problem, const Design& design, int steps);

/// The crank angles of that table: the ends of the motion, and `steps` - 1 evenly between them. Radians; none where the
/// design does not assemble anywhere.
std::vector<double> motion_angles(const Problem& problem, const Motion& motion, int steps);

/// One row of it, in the file's units: an entry for each of Mechanism::motion_columns at a crank angle (radians).
/// Returns false where the mechanism does not assemble.
bool motion_row(const Problem& problem, const Motion& motion, const Design& design, double crank_angle,
                std::span<double> row);

/// Its first line alone: what there is to say of a design that was not found.
std::string motion_header(const Problem& problem);

}  // namespace mechwright
