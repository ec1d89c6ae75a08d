#pragma once
/// \file
/// The coupler point of the four-bar as a path-guiding point, with derivatives.

#include <span>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright::four_bar {

/// Dimensions that the path depends on: links, coupler point, origin and tilt. See Mechanism::path_miss.
inline constexpr std::size_t path_reads = 9;

void path_miss(std::size_t assembly, std::span<const double> dimensions, double crank_angle,
               const Vector<double>& target, PathMiss& out);

}  // namespace mechwright::four_bar
