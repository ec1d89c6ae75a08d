#pragma once
/// \file
/// The four conditions on the dyad that ends on an output: one for each accuracy point after the first, and lines on
/// which its pivots are where coordinates of them are known.

#include <array>

#include "synthesis/exact/output_dyads/dyad_plan.h"
#include "synthesis/exact/poses/certified_dyad.h"

namespace mechwright {

/// Conditions first of displacements, then of lines of the moving pivot, then of lines of the fixed one. Lengths are
/// over `size`.
template <class T>
struct OutputConditions {
    std::array<std::array<T, 7>, 4> rows{};
    std::size_t displacements = 0;
    std::size_t moving_lines = 0;  ///< of the lever's pivot; two give it a place
    std::size_t fixed_lines = 0;   ///< of its arm
};

/// For dimensions of which those that are found count for nothing. Precondition: the plan has no why_not, and there are
/// as many places as it has points.
OutputConditions<double> output_conditions(const LinkageModel& model, const DyadPlan& plan, std::size_t start,
                                           const KnownPlaces<double>& known, std::span<const double> dimensions,
                                           double size);
OutputConditions<Digits50> output_conditions(const LinkageModel& model, const DyadPlan& plan, std::size_t start,
                                             const KnownPlaces<Digits50>& known, std::span<const Digits50> dimensions,
                                             double size);

/// All dyads that meet them, over the complex numbers: four at most, one where a pivot has its place.
DyadSolutions dyads_meeting(const OutputConditions<double>& conditions);

}  // namespace mechwright
