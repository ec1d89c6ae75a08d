#pragma once
/// \file
/// Six-bars in plain complex numbers, for problems whose answer is known.

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

namespace mechwright::bench {

using Complex = std::complex<double>;

inline constexpr double turn = 2 * std::numbers::pi;

/// Where circles about a and b meet, to the left of the line from a to b for side 1; nothing where they do not, or so
/// that their radii stand at less than 20 deg to each other.
inline std::optional<Complex> meeting(const Complex& a, const Complex& b, double of_a, double of_b, double side) {
    constexpr double of_twenty_degrees = 0.94;
    const double apart = std::abs(b - a);
    const double cosine = (of_a * of_a + of_b * of_b - apart * apart) / (2 * of_a * of_b);
    if (!(std::abs(cosine) < of_twenty_degrees)) return {};
    const double along = (apart * apart + of_a * of_a - of_b * of_b) / (2 * apart);
    return a + (b - a) / apart * Complex(along, side * std::sqrt(of_a * of_a - along * along));
}

struct SixBar {
    bool watt;  ///< of Watt's first kind, else of Stephenson's third
    double ground, crank, coupler, rocker, rod, last;
    Complex e, f, p;  ///< on coupler, on rocker or frame, on rod
    double side_c, side_g;

    std::optional<Complex> point(double angle) const {
        const Complex b = std::polar(crank, angle);
        const auto c = meeting(b, ground, coupler, rocker, side_c);
        if (!c) return {};
        const Complex on_coupler = b + e * (*c - b) / coupler;
        const Complex pivot = watt ? ground + f * (*c - ground) / rocker : f;
        const auto g = meeting(on_coupler, pivot, rod, last, side_g);
        if (!g) return {};
        return on_coupler + p * (*g - on_coupler) / rod;
    }
    bool turns() const {
        constexpr int steps = 360;
        for (int i = 0; i < steps; ++i)
            if (!point(turn * i / steps)) return false;
        return true;
    }
};

}  // namespace mechwright::bench
