#pragma once
/// \file
/// What a path brings to a program beside its outputs: targets, crank angles as variables, their order as rows.

#include "synthesis/program/program.h"

namespace mechwright {

/// To a program that has its dimensions, of a problem with a path.
void add_path_rows(Program& program);

}  // namespace mechwright
