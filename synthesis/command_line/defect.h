#pragma once
/// \file
/// What cannot happen and did.

#include <string_view>

#include "synthesis/command_line/console.h"

namespace mechwright {

/// To be called while an exception is being handled: says what it was, while working on what (may be empty), and how to
/// report it. Returns the exit code.
int report_defect(Console& console, std::string_view working_on);

}  // namespace mechwright
