#pragma once
/// \file
/// Crank-rockers of given swing and time ratio: a one-parameter family in closed form, and its member with the best
/// least transmission angle.

#include <optional>

#include "analysis/four_bar/four_bar.h"

namespace mechwright {

/// The crank-rocker with ground link 1 whose rocker swings through `swing` while the crank turns through
/// `forward_stroke` (radians, in (0, 2 pi), not pi), and whose least transmission angle is the greatest. Nothing where
/// that optimum does not exist: the family then ends before it (its best member has a link of length zero, another
/// swing, or a crank that is not the shortest link).
///
/// Derivation: with lambda = coupler/crank and kappa = (forward_stroke - swing)/2,
///   crank^2  = sin^2(swing/2) / D,  D = lambda^2 cos^2 kappa + sin^2 kappa,
///   rocker^2 = (lambda^2 cos^2(forward_stroke/2) + sin^2(forward_stroke/2)) / D,
/// and the derivative of the cosine of the least transmission angle vanishes at the one positive root Q = lambda^2 of
///   (1 + t^2) Q^3 + t^2 v^2 (Q^2 - 2 Q - t^2) = 0,  t = tan(forward_stroke/2), v = tan kappa.
std::optional<FourBar<double>> best_transmission_crank_rocker(double swing, double forward_stroke);

}  // namespace mechwright
