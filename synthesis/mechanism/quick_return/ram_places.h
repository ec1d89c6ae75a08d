#pragma once
/// \file
/// Where the ram's motion is stationary, in fifty digits: what both the measures and the checks of verification look
/// for.

#include <vector>

#include "synthesis/mechanism/quick_return/ram_again.h"
#include "synthesis/mechanism/stationary.h"

namespace mechwright::quick_return::again {

/// What can be stationary.
enum class Slope { rod_height, position, velocity, acceleration };

template <class T>
T slope_of(const RamState<T>& s, Slope what) {
    switch (what) {
        case Slope::rod_height: return s.height.c[1];
        case Slope::position: return s.position.c[1];
        case Slope::velocity: return s.position.c[2];
        case Slope::acceleration: return s.position.c[3];
    }
    return T(0);
}

/// The zeros of a slope over a sweep. The ram is fast where the rod stands steepest, so samples gather there.
template <class Geometry>
std::vector<Digits50> stationary_crank_angles(const Rebuilt<Geometry>& m, const Sweep& sweep, Slope what) {
    std::vector<double> fast;
    const auto height_slope = [&](double x) { return m.at(x).height.c[1]; };
    for (const Bracket& b : brackets_of_zeros(height_slope, sample_angles(sweep)))
        fast.push_back(detail::zero_between_signs(height_slope, b.left, b.right, height_slope(b.left),
                                                  height_slope(b.right), 1e-15));
    return stationary_points(
        sweep, [&](double x) { return slope_of(m.at(x), what); },
        [&](const Digits50& x) { return slope_of(m.at(x), what); }, fast);
}

}  // namespace mechwright::quick_return::again
