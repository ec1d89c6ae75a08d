#pragma once
/// \file
/// What a summary says of a function that is generated.

#include <string>

#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/result.h"
#include "synthesis/report/text/numbers.h"

namespace mechwright {

/// A heading, where the error is extreme, and what the number of extremes says.
std::string function_section(const Problem& problem, const InputTask& task, const Design& design,
                             const TextStyle& style);

}  // namespace mechwright
