#pragma once
/// \file
/// The tasks that `mechwright new` begins with mechanisms that drive a ram.

#include "synthesis/mechanism/task.h"

namespace mechwright {

std::vector<Task> slider_crank_tasks();
std::vector<Task> crank_shaper_tasks();
std::vector<Task> whitworth_tasks();
std::vector<Task> drag_link_tasks();

}  // namespace mechwright
