#pragma once
/// \file
/// Where closed forms for the size of a cam begin.

#include "synthesis/program/result.h"

namespace mechwright {

/// Every dimension as small as the problem allows.
inline Design smallest_design(const Problem& problem, std::size_t assembly) {
    Design design;
    design.assembly = assembly;
    for (const DimensionRange& range : problem.dimensions)
        design.dimensions.push_back(range.min);
    return design;
}

}  // namespace mechwright
