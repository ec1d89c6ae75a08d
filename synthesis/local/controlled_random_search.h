#pragma once
/// \file
/// Controlled random search by NLopt 2.7.1 (CRS2 with local mutation): a peer that ours are compared with.

#include <functional>
#include <vector>

namespace mechwright {

/// A function without derivatives on a box, to be minimised.
struct BoxFunction {
    std::function<double(const std::vector<double>&)> value;
    std::vector<double> lower;  ///< finite, as are the upper ends
    std::vector<double> upper;
};

/// The point that a run of at most so many evaluations, with NLopt's own defaults, ends at. The solver's word is not
/// passed on. One run at a time: its random numbers are those of the process.
std::vector<double> controlled_random_search(const BoxFunction& function, std::vector<double> start,
                                             int most_evaluations, unsigned long seed);

}  // namespace mechwright
