#pragma once
/// \file
/// The chords of a sampled curve that are nearest to targets.

#include "synthesis/mechanism/curve_fit.h"

namespace mechwright {

/// Targets counted from where a mechanism stands: its origin, and its x axis turned by `tilt` radians.
void targets_in_frame(const GroupedTargets& targets, const Vector<double>& origin, double tilt, GroupedTargets& out);

/// Chords at which a curve comes near to targets once more, about as near as at the nearest: the curve, which is beside
/// its chords, may be nearer there. In groups as the targets are.
struct OtherChords {
    std::vector<std::size_t> target{};  ///< the number of each
    GroupedTargets targets{};
    NearestChords chords{};
};

/// Of each target the nearest chord, the first of those that are equally near. Precondition: at least two samples.
void nearest_chords(InstructionSet set, const SampledCurve& curve, const GroupedTargets& targets, NearestChords& out);

/// And the other ones.
void nearest_chords(InstructionSet set, const SampledCurve& curve, const GroupedTargets& targets, NearestChords& out,
                    OtherChords& others);

}  // namespace mechwright
