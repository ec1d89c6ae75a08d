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

/// No crank-rocker of this family has a worst transmission angle (radians) above this; 0 where the family is empty.
///
/// Derivation: with crank 1, coupler lambda and the crank pivot at the origin, the rocker pin is at its limits at
/// B1 = lambda + 1 and B2 = (lambda - 1) e^(i alpha), alpha = pi - forward_stroke, and the rocker pivot is the apex of
/// the isosceles triangle over B1 B2 with the angle `swing`. Both limits belong to one assembly if it lies on the same
/// side of the rays to B1 and B2: (lambda - 1)/(lambda + 1) < min(m, 1/m), m = cos(alpha + swing/2)/cos(swing/2), so
/// that the family is empty unless m > 0. The transmission angle at the crank angle 0 rises with lambda up to the root
/// Q above: its value there, or at the end of the family if that comes first, bounds the worst one.
double transmission_bound_of_crank_rockers(double swing, double forward_stroke);

}  // namespace mechwright
