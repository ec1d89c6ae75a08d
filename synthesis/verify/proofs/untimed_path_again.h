#pragma once
/// \file
/// Whether the coupler curves of all four-bars miss points by so much, for verification: the inequality of
/// synthesis/proof/coupler_sextic.h in fifty digits, with parts of the functions that are followed round a circle as
/// waves, in complex numbers. Weights that somebody has found are its witness; any prove what they prove.
///
/// With u_k of size 1 and v_k(theta) the part of degree k of f(p + r e^(i theta)) - f(p), the sum of r^k u_k . v_k is a
/// trigonometric polynomial of degree 3. By M. Riesz (1914) it is nowhere greater than at some of 2 N places that are
/// spread evenly over a turn, over cos(3 pi / (2 N)); so the sum of r^k |v_k| is not either.

#include <span>

#include "analysis/geometry/vector.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

struct MissedPoints {
    std::span<const Vector<double>> points;
    std::span<const double> weights;  ///< of their squared distances
    std::span<const double> witness;  ///< one for each point, > 0
};

/// Whether no curve has a lesser weighted sum of squared distances from the points; false where the witness does not
/// show it.
bool no_curve_has_lesser_sum(const MissedPoints& missed, const Digits50& sum);

/// Whether no curve comes nearer than a distance > 0 to all of the points.
bool no_curve_comes_within(const MissedPoints& missed, const Digits50& distance);

}  // namespace mechwright
