#pragma once
/// \file
/// Searches of a path's fit, one after the other: which of them are gone on with.

#include <cstdint>
#include <vector>

#include "synthesis/local/local.h"

namespace mechwright {

/// Where a search of a fit begins.
enum class TrialStart : std::uint8_t { drawn, about_part, nearby };

/// A search of a fit. Its program is one that has all kinds of motion among its designs, where there is such a one.
struct Trial {
    std::size_t program = 0;
    LocalOutcome outcome;
    TrialStart from = TrialStart::drawn;
    long evaluations = 0;
    double seconds = 0;  ///< where a trace is kept
};

/// Best first; those that are equally good in the order in which they are given.
void sort_by_sum(std::vector<Trial>& trials);

/// Keeps the most promising of sorted ones, no more than `most`; of those that have come to about the same sum of
/// squares only the first few.
void keep_different(std::vector<Trial>& trials, int most);

/// The best few of sorted ones that ended at different sums.
std::vector<Trial> elites_of(const std::vector<Trial>& sorted);

}  // namespace mechwright
