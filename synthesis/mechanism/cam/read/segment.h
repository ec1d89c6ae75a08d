#pragma once
/// \file
/// One [[segment]] of a cam's motion.

#include <cstddef>
#include <numbers>

#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/problem/problem.h"
#include "synthesis/problem/toml/section.h"

namespace mechwright::reading {

inline constexpr double whole_turn = 2 * std::numbers::pi;

struct ReadSegment {
    SegmentPlan plan{};
    bool whole = true;  ///< kind, angle and lift could be read
};

/// Reads the segment of an index, its dimensions into the problem. `coefficients` counts those of polynomials and
/// splines that are used so far.
ReadSegment read_segment(Section section, std::size_t index, std::size_t& coefficients, Problem& problem,
                         Messages& messages);

}  // namespace mechwright::reading
