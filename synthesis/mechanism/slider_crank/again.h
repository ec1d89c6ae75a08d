#pragma once
/// \file
/// The slider-crank measured a second time, for verification (quick_return/again.h).

#include "synthesis/mechanism/quick_return/again.h"
#include "synthesis/mechanism/quick_return/ram_again.h"

namespace mechwright::quick_return {

namespace again {

struct SliderCrankGeometry : UsualGeometry {
    static constexpr std::array<std::size_t, 2> links{0, 1};
    static constexpr std::array<std::size_t, 2> lengths{0, 1};

    template <class T>
    struct Input {};
    template <class To, class From>
    static Input<To> rounded_input(const Input<From>&) {
        return {};
    }
    static Input<Digits50> input(std::size_t, std::span<const Digits50>, const Digits50&) { return {}; }
    static Rod<Digits50> rod(std::span<const Digits50> d, const Digits50& unit) {
        return rod_of(d[0] / unit, d[1] / unit, d[2] / unit);
    }
    template <class T>
    static Vector<Jet<T>> arm_direction(const Input<T>&, const Jet<T>& crank_angle) {
        const auto angle = sine_cosine(crank_angle);
        return {angle.cosine, angle.sine};
    }
    /// Whether the input turns or swings as the mechanism's name says, and the rod never stops it.
    static bool works(std::span<const Digits50> d) { return d[0] + abs(d[2]) <= d[1]; }
};

}  // namespace again

using SliderCrankAgain = again::RamAgain<again::SliderCrankGeometry>;

/// The ways in which it can move (Mechanism::ways_again).
std::vector<Way> slider_crank_ways(bool full_turn);

/// The point of a slider-crank's rod in the drawing at a crank angle (radians, counted from the slide); NaN where the
/// mechanism does not assemble.
Vector<Digits50> rod_path_point(Form form, std::span<const Digits50> dimensions, const Digits50& crank_angle);

}  // namespace mechwright::quick_return
