#pragma once
/// \file
/// How something changes with the dimensions that a problem leaves open.

#include <Eigen/Core>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// Slopes by the arguments of a formula, [row][argument], as those by all dimensions of the mechanism,
/// [row][dimension]: what is tied counts by what it follows, columns of dimensions that are given are zero.
Eigen::MatrixXd by_free_dimensions(const Problem& problem, const Reads& reads, const Eigen::MatrixXd& slopes);

/// Columns of unit length, but those that are zero.
void scale_columns(Eigen::MatrixXd& slopes);

/// How many columns are independent: they differ by more than a ten-millionth of their length.
int independent_columns(Eigen::MatrixXd slopes);

}  // namespace mechwright
