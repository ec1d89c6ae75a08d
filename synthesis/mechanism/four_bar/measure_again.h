#pragma once
/// \file
/// The quantities of a four-bar measured a second time, for verification: over the continuous motion, in fifty digits,
/// from a pose that is rebuilt by plain circle intersection. Nothing of analysis/four_bar is used, so that a mistake
/// there cannot hide here.
///
/// Every function takes the motion (see Motion; families 0 crank-rocker, 1 double crank, 2 limited) and the dimensions
/// in the mechanism's order: ground, crank, coupler, rocker, and for the path point also point-along, point-across,
/// origin-x, origin-y, tilt, crank-start; lengths in any one unit, angles in radians. Assembly 0 is open (the rocker
/// pin lies left of the line from crank pin to rocker pivot), 1 is crossed. A quantity that is not defined for the
/// motion, or a motion that cannot be, gives NaN.

#include <span>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright::four_bar {

/// Slow over fast stroke of the rocker of a crank-rocker: the crank angles between the two extremes of the rocker
/// angle.
Digits50 time_ratio_again(const Motion& motion, std::span<const Digits50> dimensions);

/// Greatest less least angle of the rocker of a crank-rocker over a full turn, radians.
Digits50 swing_again(const Motion& motion, std::span<const Digits50> dimensions);

/// The least and the greatest angle between coupler and rocker, and the least of all angles and their supplements,
/// radians in [0, pi].
Digits50 transmission_angle_min_again(const Motion& motion, std::span<const Digits50> dimensions);
Digits50 transmission_angle_max_again(const Motion& motion, std::span<const Digits50> dimensions);
Digits50 transmission_angle_worst_again(const Motion& motion, std::span<const Digits50> dimensions);

/// The least and the greatest angular velocity of the rocker for unit angular velocity of the crank, signed.
Digits50 velocity_ratio_min_again(const Motion& motion, std::span<const Digits50> dimensions);
Digits50 velocity_ratio_max_again(const Motion& motion, std::span<const Digits50> dimensions);

/// Longest over shortest link; the sum of the four links; p + q - s - l (both in the unit of the lengths).
Digits50 link_ratio_again(const Motion& motion, std::span<const Digits50> dimensions);
Digits50 total_length_again(const Motion& motion, std::span<const Digits50> dimensions);
Digits50 grashof_margin_again(const Motion& motion, std::span<const Digits50> dimensions);

}  // namespace mechwright::four_bar

namespace mechwright {

/// Four checks in this order: the dimensions are positive and finite; the linkage assembles over the whole motion; it
/// stays on one branch (the sine of the angle from coupler to rocker keeps its sign); it stays on one circuit. Where
/// the first fails the others are left out. Over a limited motion the two ends, and only they, may be toggle positions.
std::vector<Check> four_bar_check_motion(const Motion& motion, std::span<const Digits50> dimensions);

/// The family of a design and the crank angles over which it is judged (Mechanism::motion_again).
Motion four_bar_motion_again(Form form, std::span<const Digits50> dimensions,
                             const std::optional<Vector<Digits50>>& crank_range);

/// The ways in which it can move (Mechanism::ways_again).
std::vector<Way> four_bar_ways_again(bool full_turn);

/// The coupler point in the drawing at a crank angle (radians, counted from the ground link); NaN where the linkage
/// does not assemble.
Vector<Digits50> four_bar_path_point(Form form, std::span<const Digits50> dimensions, const Digits50& crank_angle);

}  // namespace mechwright
