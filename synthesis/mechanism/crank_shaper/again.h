#pragma once
/// \file
/// The crank shaper measured a second time, for verification (quick_return/again.h).

#include "synthesis/mechanism/quick_return/again.h"
#include "synthesis/mechanism/quick_return/ram_again.h"

namespace mechwright::quick_return {

namespace again {

/// The slide points to the left of the line of centres.
struct CrankShaperGeometry : UsualGeometry {
    static constexpr std::array<std::size_t, 4> links{0, 1, 2, 3};
    static constexpr std::array<std::size_t, 5> lengths{0, 1, 2, 3, 4};

    template <class T>
    struct Input {
        T difference, crank;
    };
    template <class To, class From>
    static Input<To> rounded_input(const Input<From>& m) {
        return {To(m.difference), To(m.crank)};
    }
    static Input<Digits50> input(std::size_t, std::span<const Digits50> d, const Digits50& unit) {
        return {(d[0] - d[1]) / unit, d[1] / unit};
    }
    static Rod<Digits50> rod(std::span<const Digits50> d, const Digits50& unit) {
        return rod_of(d[2] / unit, d[3] / unit, -d[4] / unit);
    }
    template <class T>
    static Vector<Jet<T>> arm_direction(const Input<T>& m, const Jet<T>& crank_angle) {
        const auto slot = slot_direction(m.difference, m.crank, crank_angle);
        return {slot.y, -slot.x};
    }
    /// Whether the input turns or swings as the mechanism's name says, and the rod never stops it.
    static bool works(std::span<const Digits50> d) { return d[1] < d[0]; }
    static std::vector<Check> checks_of_input(const Motion&, std::span<const Digits50> d) {
        return {{"crank is shorter than the centre distance", d[1] < d[0], by(d[0] - d[1])}};
    }
};

}  // namespace again

using CrankShaperAgain = again::RamAgain<again::CrankShaperGeometry>;

/// The ways in which it can move (Mechanism::ways_again).
std::vector<Way> crank_shaper_ways(bool full_turn);

}  // namespace mechwright::quick_return
