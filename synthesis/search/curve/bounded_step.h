#pragma once
/// \file
/// The step to the least of a quadratic model that keeps to linear limits.

#include <Eigen/Cholesky>
#include <boost/container/static_vector.hpp>

#include "synthesis/mechanism/curve_fit.h"

namespace mechwright {

inline constexpr int most_step_size = static_cast<int>(most_curve_arguments);
using StepMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_step_size, most_step_size>;
using StepVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_step_size, 1>;

/// Steps s with `normal` . s >= `least`, which is no more than 0: no step at all keeps to every limit.
struct StepLimit {
    StepVector normal;
    double least = 0;
};

/// Most limits of a step: two of each argument, and three borders.
using StepLimits = boost::container::static_vector<StepLimit, 2 * most_curve_arguments + 3>;

/// The step that makes slope . s + s . matrix s / 2 least among those that keep to the limits, to rounding, by the dual
/// method of Goldfarb and Idnani (Mathematical Programming 27, 1983): from the least of all, to a limit that is passed,
/// and so on, with limits that are no longer in the way left again. `factors` are those of the matrix.
StepVector bounded_step(const Eigen::LLT<StepMatrix>& factors, const StepVector& slope, const StepLimits& limits);

}  // namespace mechwright
