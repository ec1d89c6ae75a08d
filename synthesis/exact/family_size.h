#pragma once
/// \file
/// Designs that may be of any size: which size the ranges of a problem allow and its preferred values ask for.

#include <optional>
#include <span>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// A dimension of a design at unit size.
struct UnitDimension {
    std::size_t index;
    double value;
};

/// The factor by which all the given dimensions (lengths or coordinates, not 0) come into their ranges: that of a fixed
/// one or of a preferred value where there is one, else from the middle of what is allowed. Nothing if there is none.
std::optional<double> size_in_ranges(const Problem& problem, std::span<const UnitDimension> dimensions);

}  // namespace mechwright
