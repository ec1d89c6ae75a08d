#pragma once
/// \file
/// The program, but for what only a process has.

#include <functional>
#include <optional>

#include "synthesis/command_line/console.h"

namespace CLI {
class App;
}

namespace mechwright {

/// Does what the command line says and returns the exit code. Never throws.
int run(int argc, const char* const* argv, Console& console);

/// Reads a command line. Returns the exit code where nothing is left to do: help was asked for, or the line is wrong.
std::optional<int> read_command_line(CLI::App& program, int argc, const char* const* argv, Console& console);

/// Runs the work of a program as the environment wants it (MECHWRIGHT_INSTRUCTIONS) and returns the exit code, after a
/// look at what became of the output. Never throws: a defect is reported.
int run_guarded(Console& console, const std::function<int()>& work);

}  // namespace mechwright
