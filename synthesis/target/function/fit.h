#pragma once
/// \file
/// The links of a mechanism that come close to a function.

#include <Eigen/Core>

#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/program.h"

namespace mechwright {

/// Sets the dimensions of x that are variables to what comes close to the function of a target for the scales of x,
/// within their ranges.
void fit_function(const Program& program, const InputTask& task, Eigen::VectorXd& x);

}  // namespace mechwright
