#pragma once
/// \file
/// One batch of the search of a whole curve: it begins from nothing and knows nothing of others, so that what several
/// of them end at tells what all of them may have missed.

#include <functional>

#include "synthesis/search/curve/shapes.h"

namespace mechwright {

struct CurveBatch {
    std::vector<FittedCurve> best;  ///< different ones, best first
    long drawn = 0;
    long optimised = 0;  ///< descents that were begun
    long evaluations = 0;
};

/// Descents from shapes that are drawn, then from variations of the best of them, for so many evaluations at least, and
/// for twice as many again and again while the second half of them comes to something better: a batch ends where going
/// on gains nothing, so that what several end at can be compared. `stop` ends it before. A function of (problem, by,
/// seed) alone, unless stopped.
CurveBatch curve_batch(const CurveProblem& problem, LaidFirst by, std::uint64_t seed, long evaluations,
                       const std::function<bool()>& stop);

/// Descents from variations of designs alone, smaller ones than in a batch.
CurveBatch curve_variations(const CurveProblem& problem, const std::vector<FittedCurve>& from, std::uint64_t seed,
                            long most_evaluations, const std::function<bool()>& stop);

/// Goes down from a design until steps gain nothing but rounding.
void settle(const CurveProblem& problem, FittedCurve& design, CurveWork& work);

}  // namespace mechwright
