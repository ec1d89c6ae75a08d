#include "synthesis/exact/slider_crank.h"

#include <cmath>
#include <numbers>

namespace mechwright {

std::optional<SliderCrank<double>> best_transmission_slider_crank(double stroke, double time_ratio) {
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
