#pragma once
/// \file
/// What the quantities of cams mean to a designer.

#include <vector>

#include "synthesis/mechanism/explanations/explanations.h"

namespace mechwright {

std::vector<Explanation> cam_explanations();

}  // namespace mechwright
