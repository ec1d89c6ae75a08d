#pragma once
/// \file
/// A linkage that generates a function: one of its signals is the output (LinkageModel::over_input).

#include <cstddef>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The function that is a target of this number. Its quantities read the first `dimensions` of the mechanism, then
/// start and range of input and output.
FunctionGeneration linkage_function(const LinkageModel& model, std::size_t over_input, std::size_t dimensions);

}  // namespace mechwright
