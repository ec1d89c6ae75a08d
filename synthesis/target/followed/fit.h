#pragma once
/// \file
/// The line or the arc that comes closest to the path of a guided point.

#include <Eigen/Core>

#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/program.h"

namespace mechwright {

/// Sets the numbers of the line or arc of a target in x, as far as they are variables, to what the guided point of x is
/// closest to.
void fit_followed(const Program& program, const InputTask& task, Eigen::VectorXd& x);

}  // namespace mechwright
