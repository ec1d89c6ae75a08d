#pragma once
/// \file
/// From least squares towards the least greatest distance.

#include "synthesis/search/curve/descent.h"

namespace mechwright {

/// A design, and the greatest distance of a target from its curve.
struct GreatestDistance {
    FittedCurve design;  ///< its sum is that of the problem's own weights
    double distance = unlimited;
};

/// Least squares again and again, in which each target counts by what it has been missed by (Lawson, 1961, for linear
/// problems); the design whose greatest distance was the least of all. Nothing where the design does not assemble.
std::optional<GreatestDistance> towards_least_greatest(const CurveProblem& problem, const FittedCurve& from,
                                                       CurveWork& work);

}  // namespace mechwright
