#pragma once
/// \file
/// A curve laid over targets. With complex numbers a point of a link passes O + A p + B w, where p is the pin that the
/// link turns about and w the link's direction at a crank angle, O the origin, A size and tilt, B the place of the
/// point on its link (path_screening.h). For given crank angles at the targets the best O, A and B are a linear
/// problem; the nearest points of the curve then give better crank angles, and so on in turn.

#include <vector>

#include "synthesis/search/curve/descent.h"

namespace mechwright {

/// For each target the part of the motion, from 0 to 1, after which the point is nearest to it. Empty where the links
/// assemble nowhere.
std::vector<double> times_at_targets(const CurveProblem& problem, const FittedCurve& design, CurveWork& work);

/// A place for a curve, whatever the order of its targets: turned by an angle, its spread so many times theirs, and its
/// middle off theirs by so many times its own spread. The spread is the root mean square distance from the middle.
struct CurvePlace {
    double turn;  ///< radians
    double size;
    Vector<double> off;
};

/// A design with the proportions of the one given, and its point, size and placement as far as they are free, laid so
/// that it meets the targets at such times as well as it can, then by nearest points again and again. Nothing where the
/// links assemble nowhere or the curve is a point. The placement must be free.
std::optional<FittedCurve> laid(const CurveProblem& problem, FittedCurve design, const std::vector<double>& times,
                                int repetitions, CurveWork& work);

/// The same, but that it begins with the nearest points of the curve at such a place, in a size that is allowed.
std::optional<FittedCurve> laid(const CurveProblem& problem, FittedCurve design, const CurvePlace& first,
                                int repetitions, CurveWork& work);

}  // namespace mechwright
