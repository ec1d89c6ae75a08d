#pragma once
/// \file
/// What is known of the numbers of a linkage's links where the places of its pins are known.

#include <complex>
#include <vector>

#include "synthesis/exact/chains/guided_chains.h"
#include "synthesis/exact/chains/link_numbers.h"
#include "synthesis/exact/guided_parts.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

/// One way to read the links in the drawing: a link that is given by a line has two.
struct ChainReading {
    std::vector<ChainRow> rows;
    std::complex<double> frame, crank, body;  ///< the directions of their x axes
    std::complex<double> along;               ///< of the line of a ram or block
};

/// All readings of parts that are in the drawing's units; none where a link's frame cannot be told from its points.
std::vector<ChainReading> readings_of(const Problem& problem, const GuidedChains& chains, const GuidedParts& parts,
                                      std::complex<double> guided_point);

}  // namespace mechwright
