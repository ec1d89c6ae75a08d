#pragma once
/// \file
/// The Burmester curves of a problem's four poses as a table for other programs.

#include <string>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// Whether a problem is one of four poses that are to be met exactly.
bool has_burmester_curves(const Problem& problem);

/// Comma-separated values: a line of column names with units, then for every point of the curves the number of its
/// stretch, the fixed pivot in the drawing, and the moving pivot that goes with it in the first pose. Points are a
/// fiftieth of the poses' size apart, and no farther away than ten times that size.
std::string burmester_table(const Problem& problem);

}  // namespace mechwright
