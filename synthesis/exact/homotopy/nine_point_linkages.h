#pragma once
/// \file
/// The four-bars that a solution of the nine-point system stands for.

#include <array>
#include <optional>
#include <vector>

#include "analysis/four_bar/cognates.h"
#include "synthesis/exact/homotopy/nine_point_solutions.h"

namespace mechwright::homotopy {

/// The three cognates of a solution, each with its dyads both ways round.
std::array<NinePointValues, 6> orbit_members(const NinePointValues& solution);

/// A four-bar through nine points, with the crank angle (radians, from the ground link) at which it meets each.
struct LinkageThroughPoints {
    PathLinkage<double> linkage;  ///< the assembly at the first point
    std::array<double, 9> crank_angles;
    bool one_assembly = false;  ///< it meets all points in the same assembly: no branch defect
};

/// The four-bar of a real solution of the target; nothing where a link has no length.
std::optional<LinkageThroughPoints> linkage_of(const NinePointValues& solution, const NinePointTarget& target);

/// The crank angles continued from each point to the next in one direction; nothing where that takes a turn or more:
/// the points are not met in their order.
std::optional<std::vector<double>> in_order(const std::array<double, 9>& crank_angles);

}  // namespace mechwright::homotopy
