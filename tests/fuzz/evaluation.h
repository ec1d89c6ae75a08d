#pragma once
/// \file
/// What must hold of a valid problem beyond its reading: it can be evaluated, and written down and read again.

#include <string_view>

#include "synthesis/problem/problem.h"

namespace mechwright::test {

/// Builds the programs of the problem's first variants and evaluates each once, with its derivatives.
void check_evaluation(const Problem& problem);

/// The problem in `text` is the same after its table is written as TOML anew, and as a varied problem that varies
/// nothing.
void check_round_trip(std::string_view text, const Problem& problem);

}  // namespace mechwright::test
