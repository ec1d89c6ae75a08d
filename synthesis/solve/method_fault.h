#pragma once
/// \file
/// Whether the method that is asked for can be used.

#include <optional>
#include <string>

#include "synthesis/problem/reader.h"

namespace mechwright {

/// What is wrong with the name of a method, whatever the problem. Empty if nothing is.
std::string method_name_fault(const std::string& method);

/// What is wrong with a method for a problem: there is none of this name, or it does not apply. Empty if nothing is.
std::string method_fault(const std::string& method, const Problem& problem);

/// What is wrong with the method that the problem file names.
std::optional<Message> solver_method_fault(const Problem& problem);

}  // namespace mechwright
