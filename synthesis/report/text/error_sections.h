#pragma once
/// \file
/// What is said of the error of a function, a line or an arc: where it is extreme, and what the number of extremes
/// says.

#include <string>

#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/result.h"
#include "synthesis/report/text/numbers.h"

namespace mechwright {

/// A table of the extremes, each "`what` place is error", and what their number says.
std::string extremes_text(const Problem& problem, const InputTask& task, const Design& design, const std::string& what,
                          int digits);

/// A line for each extreme, and what their number says; empty where the problem has none of the three.
std::string error_section(const Problem& problem, const Design& design, const TextStyle& style);

}  // namespace mechwright
