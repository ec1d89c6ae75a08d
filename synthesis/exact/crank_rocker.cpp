#include "synthesis/exact/crank_rocker.h"

#include <algorithm>
#include <cmath>

#include "analysis/extremes.h"
#include "analysis/four_bar.h"

namespace mechwright {

namespace {

/// The positive root of the cubic in Q, each term divided so that none overflows near forward_stroke = pi.
double optimal_ratio_square(double half_stroke, double kappa) {
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
FourBar<double> member(double swing_angle, double forward_stroke, double q) {
    const double half = forward_stroke / 2;
    const double kappa = (forward_stroke - swing_angle) / 2;
    const double d = std::hypot(std::sqrt(q) * std::cos(kappa), std::sin(kappa));
    const double crank = std::abs(std::sin(swing_angle / 2)) / d;
    return {1.0, crank, std::sqrt(q) * crank, std::hypot(std::sqrt(q) * std::cos(half), std::sin(half)) / d};
}

double optimum_of_family(double swing_angle, double forward_stroke) {
    return optimal_ratio_square(forward_stroke / 2, (forward_stroke - swing_angle) / 2);
}

}  // namespace

std::optional<FourBar<double>> best_transmission_crank_rocker(double swing_angle, double forward_stroke) {
    const FourBar<double> m = member(swing_angle, forward_stroke, optimum_of_family(swing_angle, forward_stroke));
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

double transmission_bound_of_crank_rockers(double swing_angle, double forward_stroke) {
    const double alpha = pi<double>() - forward_stroke;
    const double m = std::cos(alpha + swing_angle / 2) / std::cos(swing_angle / 2);
    if (!(m > 0)) return 0;
    const double end = std::min(m, 1 / m);
    const double lambda = (1 + end) / (1 - end);
    const double q = std::min(optimum_of_family(swing_angle, forward_stroke), lambda * lambda);
    return transmission_angle(member(swing_angle, forward_stroke, q), HalfTurn<double>{1, 0});
}

}  // namespace mechwright
