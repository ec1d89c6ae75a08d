#pragma once
/// \file
/// Paths of the nine-point system, followed in the widest lanes of the processor and shared between threads.

#include <vector>

#include "analysis/numbers/instruction_set.h"
#include "synthesis/exact/homotopy/nine_point_system.h"
#include "synthesis/exact/homotopy/tracker.h"

namespace mechwright::homotopy {

using NinePointValues = NinePointSystem::Point<double>;
using NinePointParameters = NinePointSystem::Parameters<double>;
using NinePointPath = TrackedPath<NinePointSystem>;

/// The paths from solutions at some parameters to those at others, in their order; the same digits for any number of
/// jobs and any instruction set.
std::vector<NinePointPath> track(const std::vector<NinePointValues>& starts, const NinePointParameters& from,
                                 const NinePointParameters& to, const TrackingOptions& options, int jobs,
                                 InstructionSet set = widest_instruction_set());

/// The same with twice the digits, for paths that double does not suffice for: from where they have been followed to.
std::vector<NinePointPath> track_wide(const std::vector<NinePointPath>& stopped, const NinePointParameters& from,
                                      const NinePointParameters& to, const TrackingOptions& options, int jobs,
                                      InstructionSet set = widest_instruction_set());

/// A path that is to be followed from its beginning.
NinePointPath beginning_at(const NinePointValues& solution);

/// Newton's corrections with twice the digits, to where they come to an end. Returns the last one's size relative to
/// the solution: near the rounding of double where the solution is regular.
double refine(NinePointValues& solution, const NinePointParameters& at);

}  // namespace mechwright::homotopy
