#pragma once
/// \file
/// The inputs of its master over which a linkage is looked at.

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <span>

#include "analysis/linkage/structure/structure.h"

namespace mechwright::linkage {

struct Inputs {
    double from = 0;
    double to = 2 * std::numbers::pi;
    bool cyclic = true;  ///< `to` is `from` again
};

/// So many turns of a drive that turns; the displacements of a driven slide of a linkage of some size, far beyond where
/// anything closes; with stops from a little before the one to a little beyond the other, in which they are found.
inline Inputs inputs_of(const Structure& s, std::span<const double> numbers, double size, int turns) {
    constexpr double sizes = 4, beyond = 1e-2;
    const Drive& master = s.drives.front();
    Inputs inputs = master.of_slide ? Inputs{-sizes * size, sizes * size, false}
                                    : Inputs{0, 2 * std::numbers::pi * turns, !master.stops.any()};
    const double more = beyond * (master.of_slide ? size : 1);
    if (master.stops.min) inputs.from = numbers[*master.stops.min] - more;
    if (master.stops.max) inputs.to = numbers[*master.stops.max] + more;
    inputs.to = std::max(inputs.from, inputs.to);
    return inputs;
}

}  // namespace mechwright::linkage
