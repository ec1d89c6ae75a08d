#pragma once
/// \file
/// Tolerances of lengths that standards give, by nominal size. All in millimetres.

#include <optional>

namespace mechwright {

/// The width of the tolerance of a grade of ISO 286-1, 5 to 13, for a size (0 < size <= 3150); nothing for others.
std::optional<double> iso_tolerance(int grade, double size);

/// The width of the general tolerance of ISO 2768-1 for lengths, twice its limit deviation: class 1 (f, fine), 2 (m,
/// medium), 3 (c, coarse) or 4 (v, very coarse) and a size from 0.5 to 4000; nothing where the standard has none.
std::optional<double> general_tolerance(int tolerance_class, double size);

}  // namespace mechwright
