#pragma once
/// \file
/// Small dense linear programs.

#include <Eigen/Core>

namespace mechwright {

/// Minimise cost z subject to rows z <= limit. The rows must bound z in every direction in which the cost falls.
struct LinearProgram {
    Eigen::VectorXd cost;   ///< [variable]
    Eigen::MatrixXd rows;   ///< [constraint][variable]
    Eigen::VectorXd limit;  ///< [constraint]
};

/// The optimum, from a feasible start, by steps down the projected cost until constraints block them (active set
/// method; Fletcher, Practical Methods of Optimization, section 8.3). Where degenerate constraints make it go round in
/// circles, a feasible point that is no worse than the start.
Eigen::VectorXd solution_of(const LinearProgram& program, Eigen::VectorXd start);

}  // namespace mechwright
