#pragma once
/// \file
/// What is said of the error of a function, a line or an arc: where it is extreme, and what the number of extremes
/// says.

#include <string>

#include "synthesis/program/result.h"

namespace mechwright {

/// A line for each extreme, and what their number says; empty where the problem has none of the three.
std::string error_section(const Problem& problem, const Design& design, bool colour);

}  // namespace mechwright
