#pragma once
/// \file
/// The tasks that `mechwright new` begins with a four-bar.

#include "synthesis/mechanism/task.h"

namespace mechwright {

std::vector<Task> four_bar_tasks();

}  // namespace mechwright
