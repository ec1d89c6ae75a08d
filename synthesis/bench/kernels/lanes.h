#pragma once
/// \file
/// Four-bars in lanes: many candidates at one crank angle, by each instruction set that the processor has.

#include <array>
#include <utility>

#include "analysis/numbers/instruction_set.h"
#include "synthesis/bench/section.h"

namespace mechwright::bench {

inline constexpr std::string_view lanes_name = "four-bars in lanes";
inline constexpr std::string_view one_by_one_name = "one by one";

/// The forms that use lanes, narrowest first.
inline constexpr std::array<std::pair<InstructionSet, std::string_view>, 3> lane_names{
    {{InstructionSet::baseline, "lanes, baseline x86-64"},
     {InstructionSet::avx2, "lanes, AVX2"},
     {InstructionSet::avx512, "lanes, AVX-512"}}};

/// Rows of positions, velocities and accelerations per linkage, one by one and in lanes.
std::vector<Row> measured_lanes(const Effort& effort);

}  // namespace mechwright::bench
