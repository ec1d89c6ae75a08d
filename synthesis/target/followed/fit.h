#pragma once
/// \file
/// The line or the arc that comes closest to the path of a guided point.

#include <Eigen/Core>

#include "synthesis/program/program.h"

namespace mechwright {

/// Sets the numbers of the line or arc of x, as far as they are variables, to what the guided point of x is closest to.
void fit_followed(const Program& program, Eigen::VectorXd& x);

}  // namespace mechwright
