#pragma once
/// \file
/// What the table of the kernels says.

#include "synthesis/bench/section.h"

namespace mechwright::bench {

std::string kernels_told(const Sheet& sheet);
std::vector<Diagram> kernels_drawn(const Sheet& sheet);

}  // namespace mechwright::bench
