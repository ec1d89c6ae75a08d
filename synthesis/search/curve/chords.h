#pragma once
/// \file
/// The chords of a sampled curve that are nearest to targets.

#include "synthesis/mechanism/curve_fit.h"

namespace mechwright {

/// Targets counted from where a mechanism stands: its origin, and its x axis turned by `tilt` radians.
void targets_in_frame(const GroupedTargets& targets, const Vector<double>& origin, double tilt, GroupedTargets& out);

/// Of each target the nearest chord, the first of those that are equally near. Precondition: at least two samples.
void nearest_chords(InstructionSet set, const SampledCurve& curve, const GroupedTargets& targets, NearestChords& out);

}  // namespace mechwright
