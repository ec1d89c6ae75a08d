#pragma once
/// \file
/// Four-bars of any size, as designs of the size that the ranges of a problem ask for.

#include "synthesis/program/result.h"

namespace mechwright {

/// Link lengths in any unit.
struct SizedLinkage {
    double ground, crank, coupler, rocker;

    /// Whether none is too short, against the others, to be more than rounding.
    bool has_lengths() const;
};

/// A design with these links; everything else is as the file has it, or at the lower end of its range.
Design design_of(const Problem& problem, const SizedLinkage& linkage);

}  // namespace mechwright
