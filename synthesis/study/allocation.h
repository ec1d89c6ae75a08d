#pragma once
/// \file
/// Allocation of tolerances: of all that keep a share of pieces within the limits of a problem, those that cost least.
/// The derivatives of the limited quantities say what each tolerance does, and samples confirm it.

#include <optional>
#include <string>
#include <vector>

#include "synthesis/study/tolerance.h"

namespace mechwright {

/// What each tolerance does to a limited quantity: the variance that it adds as it is given, over the square of the
/// deviation that the limit allows. Their sum is to be at most 1.
using LimitShares = std::vector<double>;

/// How many times as wide as they are given tolerances can be, of those that keep every limit the cheapest where one
/// costs weight / times^exponent (exponent > 0); at most `widest_times`, where nothing else limits one. Every limit has
/// a share for each weight, none of them negative.
///
/// The cost is convex in the squares of the times and the limits are linear, so that the stationary point of the
/// Lagrangian, times^(exponent + 2) = exponent weight / (2 sum of multiplier share), is the only one. Derivation.
std::vector<double> cheapest_tolerances(const std::vector<LimitShares>& limits, const std::vector<double>& weights,
                                        double exponent);

constexpr double widest_times = 100;

/// Changes the sizes of a design's deviations to those that Study::allocation asks for, and says what came of it in
/// `design.allocated`; the answer is the same for any number of threads. False where no tolerance is close enough or
/// the study is ended: `why` says so.
bool allocate_tolerances(const Study& study, const StudyRunOptions& options, TolerancedDesign& design,
                         std::string& why);

}  // namespace mechwright
