#pragma once
/// \file
/// Designs that a search of a whole curve starts from: any proportions, laid over the targets; and variations of a
/// design.

#include "synthesis/search/curve/descent.h"

namespace mechwright {

/// Numbers that look random, a function of their seed alone.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}
    double even();    ///< in (0, 1)
    double normal();  ///< with mean 0 and deviation 1

private:
    std::uint64_t state_;
};

/// What the curve of a drawn shape is laid by first: crank angles at the targets, in their order, or a place on the
/// plane. Each finds designs that the other hardly ever comes to.
enum class LaidFirst { by_crank_angles, by_place };

/// A design of any proportions, its curve laid over the targets (laying.h). Nothing where the draw belongs to no
/// design.
std::optional<FittedCurve> drawn_shape(const CurveProblem& problem, LaidFirst by, RandomNumbers& random,
                                       CurveWork& work);

/// A design near another, as far as `spread` (of order 0.01 to 1) says: margins to its borders, guided point and the
/// crank angles at the targets are changed, now and then the other side of a border or the other assembly is taken, or
/// a relative of the linkage, which draws the same curve (CurveKin), is what is varied. Nothing where the draw belongs
/// to no design.
std::optional<FittedCurve> varied(const CurveProblem& problem, const FittedCurve& from, double spread,
                                  RandomNumbers& random, CurveWork& work);

}  // namespace mechwright
