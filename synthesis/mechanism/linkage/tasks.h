#pragma once
/// \file
/// The usual six-bars, with which `mechwright new` begins linkages.

#include <vector>

#include "synthesis/mechanism/task.h"

namespace mechwright {

std::vector<Task> linkage_tasks();

}  // namespace mechwright
