#pragma once
/// \file
/// The drag link measured a second time, for verification (quick_return/again.h).

#include "synthesis/mechanism/four_bar/linkage_again.h"
#include "synthesis/mechanism/four_bar/measure_again.h"
#include "synthesis/mechanism/quick_return/again.h"
#include "synthesis/mechanism/quick_return/ram_again.h"

namespace mechwright::quick_return {

namespace again {

/// The arm turns with the rocker of a four-bar.
struct DragLinkGeometry : UsualGeometry {
    static constexpr std::array<std::size_t, 6> links{0, 1, 2, 3, 4, 6};
    static constexpr std::array<std::size_t, 6> lengths{0, 1, 2, 3, 4, 6};

    template <class T>
    struct Input {
        four_bar::again::Linkage<T> linkage;
        T turn_cosine, turn_sine;  ///< from arm angle to slide angle
    };
    template <class To, class From>
    static Input<To> rounded_input(const Input<From>& m) {
        return {four_bar::again::rounded<To>(m.linkage), To(m.turn_cosine), To(m.turn_sine)};
    }
    static Input<Digits50> input(std::size_t assembly, std::span<const Digits50> d, const Digits50&) {
        const Digits50 turn = d[7] - d[5];
        return {four_bar::again::linkage(assembly, d.first(4)), cos(turn), sin(turn)};
    }
    static Rod<Digits50> rod(std::span<const Digits50> d, const Digits50& unit) {
        return rod_of(d[4] / unit, d[6] / unit, d[8] / unit);
    }
    template <class T>
    static Vector<Jet<T>> arm_direction(const Input<T>& m, const Jet<T>& crank_angle) {
        const auto p = four_bar::again::pose(four_bar::again::rounded<Jet<T>>(m.linkage), crank_angle);
        const Jet<T> per_follower = Jet<T>(T(1)) / Jet<T>(m.linkage.rocker);
        return seen_from(per_follower * p.rocker, m.turn_cosine, m.turn_sine);
    }
    /// Whether the input turns or swings as the mechanism's name says, and the rod never stops it.
    static bool works(std::span<const Digits50> d) {
        return d[0] + d[1] <= d[2] + d[3] && d[0] + abs(d[2] - d[3]) <= d[1] && d[4] + abs(d[8]) <= d[6];
    }
    static std::vector<Check> checks_of_input(const Motion& motion, std::span<const Digits50> d) {
        std::vector<Check> checks = four_bar_check_motion(motion, d.first(4));
        checks.erase(checks.begin());  // its dimensions are checked with the others
        for (Check& check : checks)
            check.name = "four-bar " + check.name;
        return checks;
    }
    /// What must be >= 0 beside the margins of the rod: how far the four-bar is from being stretched and folded.
    static constexpr std::size_t input_margins = 2;
    template <class T, class Angle>
    static std::array<Angle, 2> margins_of_input(const Input<T>& m, const Angle& crank_angle) {
        const auto pose = four_bar::again::pose(m.linkage, crank_angle);
        return {pose.stretch, pose.fold};
    }
    static constexpr bool has_four_bar = true;
};

}  // namespace again

using DragLinkAgain = again::RamAgain<again::DragLinkGeometry>;

/// The ways in which it can move (Mechanism::ways_again).
std::vector<Way> drag_link_ways(bool full_turn);

}  // namespace mechwright::quick_return
