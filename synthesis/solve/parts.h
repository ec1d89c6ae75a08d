#pragma once
/// \file
/// Problems that are solved on the way to the answer of another.

#include "synthesis/program/result.h"
#include "synthesis/program/run_options.h"

namespace mechwright {

/// Searches of the problem begin at a design, too, or as near to it as its ranges let them.
void begin_at(Problem& problem, const Design& design);

/// The options of a whole run without its messages.
RunOptions quiet(RunOptions options);

/// Starts, candidates and evaluations of a part count in the whole.
void add_work(SearchReport& whole, const SearchReport& part);

}  // namespace mechwright
