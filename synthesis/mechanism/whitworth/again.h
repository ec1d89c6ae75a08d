#pragma once
/// \file
/// Whitworth's drive measured a second time, for verification (quick_return/again.h).

#include "synthesis/mechanism/quick_return/again.h"
#include "synthesis/mechanism/quick_return/ram_again.h"

namespace mechwright::quick_return {

namespace again {

/// The arm lies opposite the slot.
struct WhitworthGeometry : UsualGeometry {
    static constexpr std::array<std::size_t, 4> links{0, 1, 2, 3};
    static constexpr std::array<std::size_t, 4> lengths{0, 1, 2, 3};

    template <class T>
    struct Input {
        T difference, crank, slide_cosine, slide_sine;
    };
    template <class To, class From>
    static Input<To> rounded_input(const Input<From>& m) {
        return {To(m.difference), To(m.crank), To(m.slide_cosine), To(m.slide_sine)};
    }
    static Input<Digits50> input(std::size_t, std::span<const Digits50> d, const Digits50& unit) {
        return {(d[0] - d[1]) / unit, d[1] / unit, cos(d[4]), sin(d[4])};
    }
    static Rod<Digits50> rod(std::span<const Digits50> d, const Digits50& unit) {
        return rod_of(d[2] / unit, d[3] / unit, 0);
    }
    template <class T>
    static Vector<Jet<T>> arm_direction(const Input<T>& m, const Jet<T>& crank_angle) {
        return seen_from(-slot_direction(m.difference, m.crank, crank_angle), m.slide_cosine, m.slide_sine);
    }
    /// Whether the input turns or swings as the mechanism's name says, and the rod never stops it.
    static bool works(std::span<const Digits50> d) { return d[1] > d[0] && d[2] <= d[3]; }
    static std::vector<Check> checks_of_input(const Motion&, std::span<const Digits50> d) {
        return {{"crank is longer than the centre distance", d[1] > d[0], by(d[1] - d[0])}};
    }
};

}  // namespace again

using WhitworthAgain = again::RamAgain<again::WhitworthGeometry>;

/// The ways in which it can move (Mechanism::ways_again).
std::vector<Way> whitworth_ways(bool full_turn);

}  // namespace mechwright::quick_return
