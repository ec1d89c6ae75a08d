#pragma once
/// \file
/// How a design stands to the requirements of its problem.

#include <optional>

#include "synthesis/program/result.h"

namespace mechwright {

/// Inside units: lengths of the file, radians.
struct Standing {
    std::optional<double> value;      ///< of the quantity; nothing where it is not defined
    std::optional<double> violation;  ///< relative to `scale`, 0 if met; nothing without a value
    double scale = 1;     ///< the greatest of the limits; if they are 0, 1 or (for lengths) the longest dimension
    double allowed = 0;   ///< what may be missing to a limit that still counts as met: the tolerance times the scale
    bool active = false;  ///< an equality, or an inequality within 1e-6 relative of a limit or beyond it
};

Standing standing_of(const Problem& problem, const Requirement& requirement, const Design& design);

/// Whether a value this far beyond its limit (negative: on the good side) makes the limit active.
bool is_active(double shortfall, const Standing& standing);

}  // namespace mechwright
