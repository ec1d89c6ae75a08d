#pragma once
/// \file
/// Crank angles at which a measure of the ram can be extreme over a motion, in a fixed number of places, so that the
/// components of a quantity stay the same functions while a design changes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "synthesis/mechanism/measured.h"
#include "synthesis/mechanism/quick_return/layout.h"

namespace mechwright::quick_return {

inline CrankRange<double> range_of(const Motion& motion) { return {motion.full_turn, motion.from, motion.to}; }

/// A place on the motion: a point where the measure is stationary, or one that is fixed.
struct RamPlace {
    double angle;
    bool stationary;
};

/// So many places in increasing order: where there are fewer stationary points, the last place is repeated; where there
/// are more, those stay at which the measure (of the crank angle) is greatest and least.
template <std::size_t count, class Measure>
std::array<RamPlace, count> stationary_places(const RamExtremes& extremes, double otherwise, const Measure& measure) {
    struct Found {
        double angle;
        double value;
    };
    std::array<Found, RamExtremes::capacity> found{};
    for (std::size_t i = 0; i < extremes.count; ++i)
        found[i] = {extremes.at[i], measure(extremes.at[i])};
    std::size_t kept = extremes.count;
    if (kept > count) {
        std::sort(found.begin(), found.begin() + kept, [](const auto& a, const auto& b) { return a.value > b.value; });
        // The greatest and the least in turn, moved to the front.
        std::array<Found, RamExtremes::capacity> chosen{};
        for (std::size_t i = 0; i < count; ++i)
            chosen[i] = i % 2 == 0 ? found[i / 2] : found[kept - 1 - i / 2];
        std::sort(chosen.begin(), chosen.begin() + count,
                  [](const auto& a, const auto& b) { return a.angle < b.angle; });
        found = chosen;
        kept = count;
    }
    std::array<RamPlace, count> places;
    for (std::size_t i = 0; i < count; ++i)
        places[i] = kept == 0 ? RamPlace{otherwise, false} : RamPlace{found[std::min(i, kept - 1)].angle, true};
    return places;
}

/// The value of a measure at a place as a function of the dimensions: f(dimensions, crank angle).
template <class T, std::size_t N, class Function>
T value_at(const std::array<T, N>& x, const RamPlace& place, const Function& f) {
    return place.stationary ? at_stationary(x, place.angle, f) : f(x, T(place.angle));
}

/// The same where every place that is fixed is the beginning of the motion.
template <class T, std::size_t N, class Function>
T value_at(const std::array<T, N>& x, const RamPlace& place, const Function& f, const Ends<T>& ends) {
    return place.stationary ? at_stationary(x, place.angle, f) : f(x, ends.from);
}

/// Whether the rod stands square to the slide at a crank angle, but for the rounding of that angle.
template <class Drive>
bool rod_is_square(const Drive& m, double crank_angle) {
    constexpr double square_within = 8e-15;
    const SliderCrank<double> output = output_of(m);
    const SliderCrankPose<double> p = ram_of(pose_at(m, crank_angle));
    return !(std::min(p.left, p.right) > square_within * (output.crank + output.rod + std::abs(output.offset)));
}

/// Whether a drive stands at a dead position, where the ram is infinitely fast, as at the ends of a limited motion: its
/// rod square to the slide, or the four-bar of a drag link at a toggle.
template <class Drive>
bool is_dead_position(const Drive& m, double crank_angle) {
    if constexpr (HasFourBar<Drive>)
        if (is_toggle(m.links, half_turn(crank_angle))) return true;
    return rod_is_square(m, crank_angle);
}

/// The position of the ram where the rod stands square to the slide.
template <class Drive, class T>
T square_position(const Drive& m, const T& crank_angle) {
    return output_of(m).crank * ram_of(pose_at(m, crank_angle)).crank.x;
}

/// Every difference of two of some values: the greatest of them is greatest less least.
template <class T, std::size_t count>
std::size_t differences(const std::array<T, count>& values, Components<T> out) {
    std::size_t k = 0;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
            if (i != j) out[k++] = values[i] - values[j];
    return k;
}

}  // namespace mechwright::quick_return
