#pragma once
/// \file
/// What is said of dwells that are to be as still as can be.

#include <string>

#include "synthesis/program/result.h"
#include "synthesis/report/text/numbers.h"

namespace mechwright {

/// Of each dwell of the objective a line for each extreme, and what their number says; empty without any.
std::string dwell_section(const Problem& problem, const Design& design, const TextStyle& style);

}  // namespace mechwright
