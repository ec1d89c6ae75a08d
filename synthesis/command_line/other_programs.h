#pragma once
/// \file
/// Programs that are built and installed with this one.

#include <filesystem>
#include <string_view>

namespace mechwright {

/// What to call a program by: its path where it stands beside this one, else its name alone, to be found in PATH.
std::filesystem::path called(std::string_view name);

}  // namespace mechwright
