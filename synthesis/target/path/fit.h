#pragma once
/// \file
/// The placement of a mechanism that comes closest to a path, or to poses.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "synthesis/program/program.h"

namespace mechwright {

/// Fits origin, size with tilt, and guided point of x to the target points by linear least squares, as far as they are
/// design variables, and keeps them in their ranges. With complex numbers the points are O + Z p_i + Y w_i: p_i the
/// guiding link's own point and w_i its direction at unit size and no tilt, both known from the link lengths and crank
/// angles; O, Z and Y the unknowns.
void fit_placement(const Program& program, Eigen::VectorXd& x);

/// The same for random candidates, most of which do not close: false, and x as it was, at the first target at which the
/// mechanism does not assemble. Targets far from each other are looked at first.
bool fit_assembled(const Program& program, Eigen::VectorXd& x);

/// Numbers from 0 to n - 1, each once, those next to each other far apart: the order in which it looks at n targets.
std::vector<std::size_t> spread_out(std::size_t n);

}  // namespace mechwright
