#pragma once
/// \file
/// What problem files say of a cam beside its dimensions: [cam] and [[segment]].

#include "synthesis/problem/sections/kinds_with_sections.h"

namespace mechwright::reading {

KindWithSections cam_sections();

}  // namespace mechwright::reading
