#pragma once
/// \file
/// What a summary says of a path or of poses.

#include <string>

#include "synthesis/program/result.h"
#include "synthesis/report/text/numbers.h"

namespace mechwright {

/// How close the path comes to the target points: each of them if they are few, else the mean and the greatest.
std::string path_section(const Problem& problem, const Design& design, const TextStyle& style);

}  // namespace mechwright
