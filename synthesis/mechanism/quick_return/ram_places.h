#pragma once
/// \file
/// Where the ram's motion is stationary, in fifty digits: what both the measures and the checks of verification look
/// for.

#include <algorithm>
#include <boost/math/constants/constants.hpp>
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

/// The crank angles at which the ram really turns back, each once: the sweep is a little longer than the turn, and
/// rounding in double can show zeros that fifty digits do not confirm.
template <class Geometry>
std::vector<Digits50> turning_points(const Rebuilt<Geometry>& m, const Motion& motion) {
    constexpr double same_within = 1e-12;       // of crank angles
    constexpr double confirmed_within = 1e-25;  // of crank angles at which fifty digits show a zero
    const Digits50& turn = boost::math::constants::two_pi<Digits50>();
    std::vector<Digits50> found;
    for (const Digits50& x : stationary_crank_angles(m, sweep_of(motion), Slope::position)) {
        const bool known = std::any_of(found.begin(), found.end(), [&](const Digits50& y) {
            const Digits50 apart = abs(x - y);
            return apart < same_within || abs(apart - turn) < same_within;
        });
        const auto position = m.at(x).position;
        const bool confirmed =
            abs(position.c[1]) < confirmed_within * std::max(Digits50(1), Digits50(abs(position.c[2])));
        if (!known && confirmed) found.push_back(x);
    }
    return found;
}

}  // namespace mechwright::quick_return::again
