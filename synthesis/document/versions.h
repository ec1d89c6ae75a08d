#pragma once
/// \file
/// Which program and which libraries these are.

#include <string>

namespace mechwright {

std::string program_version();
std::string ipopt_version();
std::string nlopt_version();
std::string eigen_version();

}  // namespace mechwright
