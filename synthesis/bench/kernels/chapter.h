#pragma once
/// \file
/// What the table of the kernels says.

#include "synthesis/bench/section.h"

namespace mechwright::bench {

std::string kernel_chapter(const Sheet& sheet);
std::vector<Diagram> kernel_diagrams(const Sheet& sheet);

}  // namespace mechwright::bench
