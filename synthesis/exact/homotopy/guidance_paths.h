#pragma once
/// \file
/// Paths of the guidance systems, followed in the widest lanes of the processor and shared between threads.

#include <vector>

#include "analysis/numbers/instruction_set.h"
#include "synthesis/exact/homotopy/guidance_system.h"
#include "synthesis/exact/homotopy/tracker.h"

namespace mechwright::homotopy {

using GuidanceValues = GuidanceSystem::Point<double>;
using GuidanceParameters = GuidanceSystem::Parameters<double>;
using GuidancePath = TrackedPath<GuidanceSystem>;

/// The paths from solutions at some parameters to those at others, in their order; the same digits for any number of
/// jobs and any instruction set. Those that `end` cuts off are too slow, and have reached nothing.
std::vector<GuidancePath> track(const GuidanceSystem& system, const std::vector<GuidanceValues>& starts,
                                const GuidanceParameters& from, const GuidanceParameters& to,
                                const TrackingOptions& options, int jobs, const RunEnd& end = {},
                                InstructionSet set = widest_instruction_set());

/// The same with twice the digits, for paths that double does not suffice for: from where they have been followed to.
std::vector<GuidancePath> track_wide(const GuidanceSystem& system, const std::vector<GuidancePath>& stopped,
                                     const GuidanceParameters& from, const GuidanceParameters& to,
                                     const TrackingOptions& options, int jobs, const RunEnd& end = {},
                                     InstructionSet set = widest_instruction_set());

/// A path that is to be followed from its beginning.
GuidancePath beginning_at(const GuidanceValues& solution);

/// Newton's corrections with twice the digits, to where they come to an end. Returns the last one's size relative to
/// the solution: near the rounding of double where the solution is regular.
double refine(const GuidanceSystem& system, GuidanceValues& solution, const GuidanceParameters& at);

}  // namespace mechwright::homotopy
