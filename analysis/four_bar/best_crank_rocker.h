#pragma once
/// \file
/// Crank-rockers of given swing and time ratio: a one-parameter family in closed form, and its member with the best
/// least transmission angle.

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/four_bar/four_bar.h"
#include "analysis/four_bar/grashof.h"
#include "analysis/four_bar/limits.h"
#include "analysis/four_bar/transmission.h"
#include "analysis/numbers/extremes.h"

namespace mechwright {

namespace detail {

/// The positive root of the cubic in Q, each term divided so that none overflows near forward_stroke = pi.
inline double optimal_ratio_square(double half_stroke, double kappa) {
    // Times cos^4(half_stroke) cos^2(kappa): with c, s of the half stroke and C, S of kappa,
    // c^2 C^2 Q^3 + s^2 S^2 (c^2 (Q^2 - 2 Q) - s^2) = 0.
    const double c2 = std::pow(std::cos(half_stroke), 2);
    const double s2 = std::pow(std::sin(half_stroke), 2);
    const double C2 = std::pow(std::cos(kappa), 2);
    const double S2 = std::pow(std::sin(kappa), 2);
    const auto cubic = [&](double q) { return c2 * C2 * q * q * q + s2 * S2 * (c2 * (q - 2) * q - s2); };
    double high = 1;
    while (cubic(high) < 0 && high < 1e30)
        high *= 2;
    return zero_between<double>(cubic, 0.0, high, cubic(0), cubic(high));
}

/// The member of the family with (coupler/crank)^2 = q, ground link 1.
inline FourBar<double> member_of_family(double swing_angle, double forward_stroke, double q) {
    const double half = forward_stroke / 2;
    const double kappa = (forward_stroke - swing_angle) / 2;
    const double d = std::hypot(std::sqrt(q) * std::cos(kappa), std::sin(kappa));
    const double crank = std::abs(std::sin(swing_angle / 2)) / d;
    return {1.0, crank, std::sqrt(q) * crank, std::hypot(std::sqrt(q) * std::cos(half), std::sin(half)) / d};
}

inline double optimum_of_family(double swing_angle, double forward_stroke) {
    return optimal_ratio_square(forward_stroke / 2, (forward_stroke - swing_angle) / 2);
}

}  // namespace detail

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
inline std::optional<FourBar<double>> best_transmission_crank_rocker(double swing_angle, double forward_stroke) {
    const FourBar<double> m =
        detail::member_of_family(swing_angle, forward_stroke, detail::optimum_of_family(swing_angle, forward_stroke));
    const auto margins = crank_rocker_margins(m);
    const bool turns = margins.ground_longest > 0 && margins.coupler_longest > 0 && margins.rocker_longest > 0;
    if (!turns) return std::nullopt;
    // On the other side of the end of the family the same lengths swing differently.
    constexpr double same = 1e-9;
    const double excess = std::abs(forward_stroke - pi<double>());
    if (std::abs(swing(m) - swing_angle) > same || std::abs(std::abs(stroke_excess(m)) - excess) > same)
        return std::nullopt;
    return m;
}

/// No crank-rocker of this family has a worst transmission angle (radians) above this; 0 where the family is empty.
///
/// Derivation: with crank 1, coupler lambda and the crank pivot at the origin, the rocker pin is at its limits at
/// B1 = lambda + 1 and B2 = (lambda - 1) e^(i alpha), alpha = pi - forward_stroke, and the rocker pivot is the apex of
/// the isosceles triangle over B1 B2 with the angle `swing`. Both limits belong to one assembly if it lies on the same
/// side of the rays to B1 and B2: (lambda - 1)/(lambda + 1) < min(m, 1/m), m = cos(alpha + swing/2)/cos(swing/2), so
/// that the family is empty unless m > 0. The transmission angle at the crank angle 0 rises with lambda up to the root
/// Q above: its value there, or at the end of the family if that comes first, bounds the worst one.
inline double transmission_bound_of_crank_rockers(double swing_angle, double forward_stroke) {
    const double alpha = pi<double>() - forward_stroke;
    const double m = std::cos(alpha + swing_angle / 2) / std::cos(swing_angle / 2);
    if (!(m > 0)) return 0;
    const double end = std::min(m, 1 / m);
    const double lambda = (1 + end) / (1 - end);
    const double q = std::min(detail::optimum_of_family(swing_angle, forward_stroke), lambda * lambda);
    return transmission_angle(detail::member_of_family(swing_angle, forward_stroke, q), HalfTurn<double>{1, 0});
}

}  // namespace mechwright
