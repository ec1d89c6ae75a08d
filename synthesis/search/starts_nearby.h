#pragma once
/// \file
/// Starts in the neighbourhood of a design that follows a path: the basin next to a good one is more often a better one
/// than a basin anywhere (basin hopping, Wales and Doye 1997).

#include <Eigen/Core>
#include <cstdint>

#include "synthesis/program/program.h"

namespace mechwright {

/// A start whose lengths are those of x times or over up to exp(spread), whose other dimensions and crank angles are
/// moved accordingly, and whose placement is fitted again as far as it is free. A function of its arguments alone.
Eigen::VectorXd start_nearby(const Program& program, Eigen::VectorXd x, double spread, std::uint64_t seed);

}  // namespace mechwright
