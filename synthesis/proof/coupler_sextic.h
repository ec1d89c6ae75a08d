#pragma once
/// \file
/// How near the coupler curve of a four-bar can come to points, whatever their order and the crank angles: bounds from
/// below that hold for all four-bars, in both assemblies, and need no search.
///
/// With complex numbers let a and b be the fixed pivots, r and s the lengths of crank and rocker, and let the pins of
/// the coupler lie at z - u w and z - v w, where z is the coupler point and w, of size 1, the direction of the coupler.
/// |z - a - u w| = r and |z - b - v w| = s are linear in w and its conjugate; with Z = z - a, Y = z - b they give
///
///   w (u v' Z' Y - u' v Z Y') = P v' Y - Q u' Z,   P = |Z|^2 + |u|^2 - r^2,   Q = |Y|^2 + |v|^2 - s^2
///
/// (' is the conjugate), and |w| = 1 the tricircular sextic |P v' Y - Q u' Z|^2 = |u v' Z' Y - u' v Z Y'|^2, as Roberts
/// (1876) found it with real numbers. Both sides are sums of z^j z'^k with j, k <= 3, and the coefficient of z^3 z'^3
/// is |u - v|^2, the square of the coupler: a point of any coupler curve is a zero of c . f, where f are the 16 real
/// functions Re and Im of z^j z'^k, and c is not 0.
///
/// Let q_i be the point of the curve nearest to the target p_i, and f such linear combinations of these functions that
/// sum_i w_i (c . f(p_i))^2 >= |c|^2; any w_i > 0 have some. With |c| = 1, as c . f(p_i) = c . (f(p_i) - f(q_i)),
///
///   1 <= sum_i min(h_i(|q_i - p_i|), l_i),   h_i(d) = w_i max |f(p_i + e) - f(p_i)|^2 over |e| <= d,
///                                            l_i = w_i |f(p_i)|^2
///
/// As h_i(d) / d^2 grows, min(h_i, l_i) is at most d^2 times l_i / r_i^2, where h_i(r_i) = l_i; so the sum of squared
/// distances is at least 1 over the greatest of these. Weights that make them equal are found in turn; any are valid.
/// f(p + e) - f(p) is a polynomial in e: on rays its parts of degree 1 to 6 are bounded each by itself, over all
/// directions by their values in some and by Bernstein's inequality.
///
/// The bound cannot reach the best four-bar: sextics of this kind have 15 parameters, coupler curves 9. Fewer than 16
/// points, and points that lie on one such sextic (three straight lines), have the bound 0.

#include <span>
#include <vector>

#include "analysis/geometry/vector.h"

namespace mechwright {

struct DistancesFromCouplerCurves {
    double sum_of_squares = 0;  ///< least weighted sum of squared distances from points to a curve
    double greatest = 0;        ///< least greatest distance
    /// The w_i that prove the one and the other; any proof of these bounds can begin with them.
    std::vector<double> weights_of_sum{};
    std::vector<double> weights_of_greatest{};
};

/// Bounds for such points. Preconditions: as many weights, all positive.
DistancesFromCouplerCurves least_distances_from_coupler_curves(std::span<const Vector<double>> points,
                                                               std::span<const double> weights);

}  // namespace mechwright
