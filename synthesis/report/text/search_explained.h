#pragma once
/// \file
/// What a search went through, for a terminal of eighty columns.

#include <string>

#include "synthesis/program/search_trace.h"
#include "synthesis/report/text/numbers.h"

namespace mechwright {

/// How many starts there were; the ends of the local searches, a row for each optimum, best first, and for each way to
/// find none, with objective and violation as we evaluate them and the solvers' own words; where the time went. But for
/// times it is the same for any number of threads.
std::string search_explained(const Problem& problem, const Result& result, const SearchTrace& trace,
                             const TextStyle& style);

}  // namespace mechwright
