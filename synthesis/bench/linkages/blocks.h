#pragma once
/// \file
/// A point of one design at a block of crank angles, one by one and in lanes: of the built-in four-bar, and of a
/// linkage.

#include "analysis/numbers/instruction_set.h"
#include "synthesis/bench/linkages/placed.h"

namespace mechwright::bench {

/// What a block is calculated by: lanes of an instruction set, or one number after the other.
struct BlockOf {
    void (*built_in)(const std::array<double, CouplerPointKernel::size>&, AngleBlock&);
    void (*linkage)(const PointOfLinkage&, AngleBlock&);
};

BlockOf block_one_by_one();
BlockOf block_in_lanes(InstructionSet set);

}  // namespace mechwright::bench
