#pragma once
/// \file
/// Scripts that complete command lines in a shell, made from the commands as they are.

#include <string>

#include "synthesis/command_line/tree.h"

namespace mechwright {

/// For bash, to be sourced or put into bash-completion's folder as `mechwright`.
std::string bash_completion(const CommandNode& program);

/// For zsh, to be put into a folder of its fpath as `_mechwright`.
std::string zsh_completion(const CommandNode& program);

/// For fish, to be put into its folder vendor_completions.d as `mechwright.fish`.
std::string fish_completion(const CommandNode& program);

}  // namespace mechwright
