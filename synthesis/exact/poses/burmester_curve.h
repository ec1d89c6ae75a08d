#pragma once
/// \file
/// The Burmester curves of four poses: all places of fixed pivots (centre points) and moving pivots (circle points) of
/// dyads that guide a body through them.

#include <span>
#include <vector>

#include "synthesis/exact/poses/dyads.h"

namespace mechwright {

/// A stretch of both curves: dyads in order, each as far from the next, fixed and moving pivot together, as asked for.
struct BurmesterStretch {
    std::vector<Dyad> dyads;
    bool closed = false;  ///< the last dyad is followed by the first
};

/// Both curves where their points are no farther than `reach` from the first pose, sampled by arc length in steps of
/// `step`, as stretches that are connected within it. Lengths should be near 1.
std::vector<BurmesterStretch> burmester_curves(std::span<const Displacement, 3> displacements, double step,
                                               double reach);

}  // namespace mechwright
