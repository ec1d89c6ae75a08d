#pragma once
/// \file
/// The slider-crank of given stroke and time ratio with the best transmission angle.

#include <cmath>
#include <numbers>
#include <optional>

#include "analysis/slider_crank/slider_crank.h"

namespace mechwright {

/// The slider-crank whose ram makes `stroke` (> 0) while the times of its two strokes are as `time_ratio` (> 1), and
/// whose least transmission angle is the greatest; its slide line lies on the left (offset > 0). Nothing for a ratio of
/// 3 or more, which no crank that turns fully can have.
///
/// Derivation. The ram's limits are seen from the crank pivot under the angle delta = pi (ratio - 1) / (ratio + 1), so
/// that the pivot lies on a circle through them. With m - delta/2 the angle at the far limit between slide and pivot,
///   crank = D cos(m) sin(delta/2), rod = D sin(m) cos(delta/2), offset = D sin(m - delta/2) sin(m + delta/2),
/// D = stroke / sin(delta). The sine of the greatest rod slope, (crank + offset)/rod, is stationary in m where
///   (cos m - k)(cos^2 m + k cos m - 1) = 0,  k = sin(delta/2):
/// cos m = k has a transmission angle of zero; the other root is the optimum.
inline std::optional<SliderCrank<double>> best_transmission_slider_crank(double stroke, double time_ratio) {
    if (!(time_ratio > 1 && time_ratio < 3)) return std::nullopt;
    const double half = 0.5 * std::numbers::pi * (time_ratio - 1) / (time_ratio + 1);
    const double k = std::sin(half);
    const double cosine = 2 / (k + std::sqrt(k * k + 4));  // (sqrt(k^2 + 4) - k) / 2
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const double m = std::atan2(sine, cosine);
    const double diameter = stroke / std::sin(2 * half);
    return SliderCrank<double>{diameter * cosine * k, diameter * sine * std::cos(half),
                               diameter * std::sin(m - half) * std::sin(m + half)};
}

}  // namespace mechwright
