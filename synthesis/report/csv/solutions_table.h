#pragma once
/// \file
/// The designs of a result as a table for other programs: one line each.

#include <string>

#include "synthesis/program/result.h"

namespace mechwright {

/// Comma-separated values: a line of column names with units, then the design, its alternatives and, where they are
/// listed, those that a defect excludes: number, defect (empty for a design that is verified), objective, the
/// dimensions that the problem names, assembly, and the crank angle at each target of a path.
std::string solutions_table(const Problem& problem, const Result& result);

}  // namespace mechwright
