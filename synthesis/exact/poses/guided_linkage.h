#pragma once
/// \file
/// A four-bar from its two dyads, and where its crank stands at each place that its coupler is to pass.

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "analysis/four_bar/cognates.h"
#include "synthesis/exact/poses/dyads.h"

namespace mechwright {

/// Where the drawing is: places are given as displacements from one of them, in units of `size`.
struct DrawingPlace {
    std::complex<double> origin;  ///< of that place, in the drawing
    double size = 1;              ///< a length of 1 in the displacements
};

/// A four-bar through places, with the crank angle (radians, from the ground link) at which it passes each.
struct GuidedLinkage {
    PathLinkage<double> linkage;  ///< the assembly at the first place; its coupler point is the body's reference point
    std::vector<double> crank_angles;
    double coupler_direction = 0;  ///< without displacement, from crank pin to rocker pin in the drawing
    bool one_assembly = false;     ///< it passes all places in the same assembly: no branch defect
};

/// The four-bar of two dyads, the first one that of the crank; nothing where a link has no length. Displacements are
/// those of all places in their order, from that in which the dyads are given.
std::optional<GuidedLinkage> linkage_of(const Dyad& crank, const Dyad& rocker,
                                        std::span<const Displacement> displacements, const DrawingPlace& place);

/// The crank angles continued from each place to the next, in either direction; nothing for one in which that takes a
/// turn or more: the places are not passed in their order.
std::vector<std::vector<double>> in_order(const std::vector<double>& crank_angles);

}  // namespace mechwright
