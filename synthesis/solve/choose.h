#pragma once
/// \file
/// From what a method found to what the user gets: designs that pass verification, and what is said of the others.

#include <cstddef>
#include <string>
#include <vector>

#include "synthesis/program/result.h"
#include "synthesis/program/run_end.h"

namespace mechwright {

/// What a method leaves for verification: candidates in order of preference, and what it can say of its search.
struct Found {
    std::vector<Solution> candidates;
    SearchReport report;
    bool infeasible = false;  ///< proved
    bool stopped = false;
    std::string note;  ///< for the user, where there are no candidates
    std::vector<ExcludedDesign> excluded{};
    std::size_t most_tried = 16;           ///< candidates, until one passes verification
    std::vector<Check> checks_of_first{};  ///< of the first candidate, where it was verified before
    std::string excluded_note{};           ///< where every solution of an exact problem is known, and excluded
};

/// A design by itself as verification sees it.
std::vector<Check> checks_of(const Problem& problem, const Solution& solution);

/// The first candidate that passes verification becomes the design, the others alternatives, or are set aside with the
/// check that they do not pass; if none passes, the first is shown.
void choose_verified(const Problem& problem, Found& found, const RunEnd& end, Result& result);

/// Every design that passes verification is one of the answers, the best first; what does not pass has a defect between
/// the points: of circuit, mostly. Where the run ends before all are verified, the best of those that were is the
/// answer.
void choose_all_verified(const Problem& problem, Found& found, const RunEnd& end, Result& result);

}  // namespace mechwright
