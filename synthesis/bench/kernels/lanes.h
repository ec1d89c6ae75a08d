#pragma once
/// \file
/// Four-bars in lanes: many candidates at one crank angle, by each instruction set that the processor has.

#include "synthesis/bench/section.h"

namespace mechwright::bench {

inline constexpr std::string_view lanes_name = "four-bars in lanes";
inline constexpr std::string_view one_by_one_name = "one by one";

/// Rows of positions, velocities and accelerations per linkage, one by one and in lanes.
std::vector<Row> measured_lanes(const Effort& effort);

}  // namespace mechwright::bench
