#pragma once
/// \file
/// The tasks that `mechwright new` begins with a cam: one for each kind of follower.

#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/mechanism/task.h"

namespace mechwright {

std::vector<Task> cam_tasks(const CamKind& kind);

}  // namespace mechwright
