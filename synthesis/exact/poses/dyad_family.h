#pragma once
/// \file
/// Dyads through two to five poses, chosen by numbers in (0, 1) where they form families.

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/exact/poses/dyads.h"

namespace mechwright {

/// A distance or coordinate that is as good as infinite, for pivots without limits.
inline constexpr double anywhere = 1e9;

/// What is asked for of a fixed pivot, in the frame of the displacements: where ranges hold one value it is met
/// exactly, where they are wider they guide the choice.
struct PivotRanges {
    std::complex<double> origin;  ///< coordinates, or distance and direction, are counted from here
    bool polar = false;           ///< (distance, direction), else (x, y)
    double first_min, first_max;
    double second_min, second_max;
};

/// How many numbers choose a dyad through so many poses, 2 to 5.
std::size_t numbers_of_dyad(std::size_t poses);

/// The dyads that the numbers stand for: with five poses all real ones, with four those whose fixed pivots lie on a
/// line, with fewer one at most. `moving_line` takes the place of that line.
std::vector<Dyad> dyads_of(std::span<const Displacement> displacements, std::span<const double> numbers,
                           const PivotRanges& ranges, const std::optional<DyadCondition>& moving_line = {});

}  // namespace mechwright
