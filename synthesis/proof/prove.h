#pragma once
/// \file
/// Lower bounds on what any design can reach: what turns the best design that was found into the best that there is.

#include <chrono>
#include <optional>
#include <string>

#include "synthesis/program/run_options.h"

namespace mechwright {

/// Why there is no bound for a problem; empty if there is one.
std::string why_no_proof(const Problem& problem);

/// Whether the bound takes milliseconds: that of a function whose scales are given.
bool is_quickly_proved(const Problem& problem);

/// A bound of the objective of a four-bar's path whose crank angles are free, in any order or not, in the objective's
/// unit: no design comes nearer to the points (coupler_sextic.h). It takes milliseconds, and is seldom close. Nothing
/// where no bound is known or it is 0.
std::optional<double> bound_of_untimed_path(const Problem& problem);

/// Bounds the objective from below and says in the report what came of it: `bound`, and where it meets the design's
/// objective `complete` with the argument. The bound looks at the target alone, not at requirements or ranges that make
/// the objective worse: where those are active a gap remains. Returns false where time or a stop ended it early.
bool prove(const Problem& problem, const Solution& best, SearchReport& report, const RunOptions& options,
           std::chrono::steady_clock::time_point deadline);

}  // namespace mechwright
