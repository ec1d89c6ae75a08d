#pragma once
/// \file
/// The program, but for what only a process has.

#include "synthesis/command_line/console.h"

namespace mechwright {

/// Does what the command line says and returns the exit code. Never throws.
int run(int argc, const char* const* argv, Console& console);

}  // namespace mechwright
