#pragma once
/// \file
/// The manual page, made from the commands as they are.

#include <string>

#include "synthesis/command_line/tree.h"

namespace mechwright {

/// mechwright(1) in the macros of man.
std::string manual_page(const CommandNode& program);

}  // namespace mechwright
