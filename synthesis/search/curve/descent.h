#pragma once
/// \file
/// Least squares of the distances from targets to the nearest points of a curve.

#include "synthesis/search/curve/chords.h"
#include "synthesis/search/curve/curve_problem.h"

namespace mechwright {

/// A design, and what it misses the targets by.
struct FittedCurve {
    CurveArguments arguments{};
    std::size_t assembly = 0;
    double sum = unlimited;  ///< of weighted squared distances, and of what requirements are missed by
};

/// Whether a sum of squares is rounding: the targets are met.
bool is_rounding(const CurveProblem& problem, double sum);

/// The memory of evaluations, kept so that each finds it there.
struct CurveWork {
    bool roughly = false;  ///< by half as many chords, and of two stretches as near to a target by one: far from an end
    SampledCurve curve;
    GroupedTargets local;
    NearestChords chords;
    NearestOnCurve nearest;
    OtherChords others;
    NearestOnCurve of_others;
    RowsBesidePath beside;
    long evaluations = 0;
};

/// Finds `work.nearest`: from the nearest chords, and, unless `roughly`, from others where the curve itself may be
/// nearer, so that the distances go steadily with the arguments. False: the links assemble nowhere.
bool find_nearest_points(const CurveProblem& problem, InstructionSet set, std::size_t assembly,
                         const CurveArguments& arguments, CurveWork& work);

/// Goes down from a design, by Levenberg's and Marquardt's method with nearest points found anew at every step, and
/// with the bends of distances that slopes have told of. Ranges are kept, and the kind of motion: where a range or a
/// border (CurveKin) is in the way the step is the best along it. Ends where steps gain less than the part `tolerance`,
/// or after so many evaluations. False: the design does not assemble.
bool descend(const CurveProblem& problem, FittedCurve& at, int most_evaluations, double tolerance, CurveWork& work);

}  // namespace mechwright
