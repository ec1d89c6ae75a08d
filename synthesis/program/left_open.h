#pragma once
/// \file
/// Whether a problem describes one mechanism.

#include <string>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// Why there is not one mechanism to be analysed: which dimensions, or the assembly, are still open. Empty if there is.
std::string why_not_analysable(const Problem& problem);

}  // namespace mechwright
