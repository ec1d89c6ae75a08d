#pragma once
/// \file
/// Start systems of homotopies as files.

#include <optional>
#include <string>
#include <vector>

#include "synthesis/command_line/console.h"
#include "synthesis/exact/homotopy/guidance_start.h"

namespace mechwright {

/// All that there are.
std::vector<std::string> start_system_names();

/// Reads a start system that `mechwright start-system` has made. Reports what is wrong with the file and returns the
/// exit code: 0, invalid_file or no_access.
int read_start_system(const std::string& file, Console& console, std::optional<homotopy::StartSystem>& start);

}  // namespace mechwright
