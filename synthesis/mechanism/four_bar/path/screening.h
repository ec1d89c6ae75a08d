#pragma once
/// \file
/// Path screening of the four-bar (path_screening.h); and the coupler point in lanes, for whoever wants many of them.

#include "analysis/four_bar/pose.h"
#include "synthesis/mechanism/path_screening.h"

namespace mechwright {

/// `lengths` are ground, crank, coupler, rocker.
Screened four_bar_screening(InstructionSet set, std::size_t assembly, std::span<const Group> lengths,
                            std::span<const ScreenedPoint> points, const PathFreedom& free);

/// Eight four-bars with their coupler points.
struct FourBarGroup {
    std::array<Group, 4> links;  ///< ground, crank, coupler, rocker
    Group along;
    Group across;
};

/// Where the coupler points of a group are at a crank angle, in the frame of the linkage; of candidates that do not
/// assemble, some point.
struct PointGroup {
    Group x;
    Group y;
};

/// The coupler points of many four-bars at one crank angle; spans of one length.
void coupler_points(InstructionSet set, Assembly assembly, std::span<const FourBarGroup> linkages,
                    const HalfTurn<double>& half, std::span<PointGroup> out);

}  // namespace mechwright
