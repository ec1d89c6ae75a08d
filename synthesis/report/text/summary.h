#pragma once
/// \file
/// A result in words and tables, for a terminal of eighty columns.

#include <string>

#include "synthesis/program/result.h"
#include "synthesis/report/text/numbers.h"

namespace mechwright {

/// What came out of a run: in one sentence, then the design, the objective, every requirement with how it is met, the
/// path, the verification and how the search went.
std::string summary(const Problem& problem, const Result& result, const TextStyle& style);

/// Over which given inputs a design does not assemble, and over which it does; empty where it does over all of them.
std::string where_it_comes_apart(const Problem& problem, const Design& design, int digits);

/// A design that was given: what kind of linkage it is, how it moves, every quantity, and its requirements and path if
/// the problem has them.
std::string analysis_summary(const Problem& problem, const Solution& solution, const TextStyle& style);

}  // namespace mechwright
