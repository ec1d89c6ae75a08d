#pragma once
/// \file
/// The best that is known of shapes that no linkage draws.

#include <array>
#include <span>
#include <string_view>

namespace mechwright::bench {

/// A design and what it misses a shape by (path-rms, mm). Dimensions in mm and degrees in the order of problem files:
/// ground, crank, coupler, rocker, point-along, point-across, origin-x, origin-y, tilt.
struct BestKnown {
    std::string_view shape;
    double rms;
    std::array<double, 9> dimensions;
    std::string_view assembly;
};

/// Found by many seeds with many starts; what is better than any of them belongs here.
std::span<const BestKnown> best_known();

}  // namespace mechwright::bench
