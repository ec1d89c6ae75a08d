#pragma once
/// \file
/// What this processor takes for each kind of operation, measured once in a run, and the least time that a mix of them
/// can take.

#include <array>
#include <cstddef>

#include "analysis/numbers/instruction_set.h"
#include "synthesis/bench/kernels/counted.h"

namespace mechwright::bench {

/// Seconds per operation and number: where many independent ones follow each other, or where each needs the one before.
struct OperationCosts {
    double sum_or_product = 0;
    double quotient = 0;
    double root = 0;
    double sine_and_cosine = 0;  ///< of one angle, from the C library; 0 in lanes, which have none
    double angle = 0;            ///< atan2
};

/// Of an instruction of any kind, at the greatest rate at which the processor takes them in.
double instruction_cost();

/// Of single numbers, independent ones.
OperationCosts scalar_costs();

/// Of single numbers, one after another.
OperationCosts scalar_latencies();

/// Of lanes, per lane, independent ones.
OperationCosts lane_costs(InstructionSet set);

/// Sums and products go through other units of the processor than quotients and roots, so that the greater of the two
/// sums is a bound; calls of the C library come on top.
double least_seconds(const OperationMix& mix, const OperationCosts& costs);

/// What a chain of operations takes by their latencies. A processor works on other calls meanwhile, as far as it sees
/// ahead.
double chain_seconds(const OperationMix& chain, const OperationCosts& latencies);

}  // namespace mechwright::bench
