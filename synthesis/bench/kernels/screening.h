#pragma once
/// \file
/// Candidates of a path search: what ranks them, by each instruction set that the processor has.

#include "synthesis/bench/section.h"

namespace mechwright::bench {

inline constexpr std::string_view screening_name = "candidates for a path of 18 timed points";

/// Rows per candidate: its best placement, size and coupler point, and the error that is left.
std::vector<Row> measured_screening(const Effort& effort);

}  // namespace mechwright::bench
