#pragma once
/// \file
/// The quantities of ram-driving mechanisms measured a second time, for verification: over the continuous motion, in
/// fifty digits, by Taylor series in the crank angle from a geometry of its own (ram_again.h). Nothing of
/// analysis/quick_return is used, so that a mistake there cannot hide here.
///
/// Every function takes the motion (families 0: two strokes in each full turn, 1: any other) and the dimensions in the
/// mechanism's order; lengths in any one unit, angles in radians. A quantity that is not defined for the motion, or a
/// motion that cannot be, gives NaN. What each quantity is stands in the registry (drive.h).

#include <span>
#include <vector>

#include "synthesis/mechanism/mechanism.h"
#include "synthesis/mechanism/quick_return/ram_again.h"

namespace mechwright::quick_return::again {

/// Families of every motion of a ram.
enum RamFamily : std::size_t { two_strokes, limited };

template <class Geometry>
struct RamAgain {
    using Dimensions = std::span<const Digits50>;

    static Digits50 stroke(const Motion& motion, Dimensions dimensions);
    static Digits50 time_ratio(const Motion& motion, Dimensions dimensions);
    static Digits50 transmission_angle_min(const Motion& motion, Dimensions dimensions);
    static Digits50 transmission_angle_max(const Motion& motion, Dimensions dimensions);
    static Digits50 transmission_angle_worst(const Motion& motion, Dimensions dimensions);
    static Digits50 ram_speed_max(const Motion& motion, Dimensions dimensions);
    static Digits50 ram_speed_min_working(const Motion& motion, Dimensions dimensions);
    static Digits50 speed_variation(const Motion& motion, Dimensions dimensions);
    static Digits50 ram_acceleration_max(const Motion& motion, Dimensions dimensions);
    static Digits50 link_ratio(const Motion& motion, Dimensions dimensions);
    static Digits50 total_length(const Motion& motion, Dimensions dimensions);

    /// The motion of a design, rebuilt as everything here: family 0 where the ram makes two strokes in each full turn
    /// as its mechanism's name says; the full turn or the widest range in which it assembles, of equally wide ones the
    /// first from crank angle 0 on; from > to where there is none.
    static Motion motion(Form form, Dimensions dimensions, const std::optional<Vector<Digits50>>& crank_range);

    /// In this order: the dimensions are positive and finite; for slotted arms, crank and centre distance are those of
    /// the mechanism; for a drag link the checks of its four-bar; the rod reaches the slide over the whole motion; it
    /// stays on one branch; where the family says so, the ram makes two strokes in each turn. Where the first fails the
    /// others are left out. Over a limited motion the two ends, and only they, may be dead positions of the rod.
    static std::vector<Check> check_motion(const Motion& motion, Dimensions dimensions);
};

}  // namespace mechwright::quick_return::again
