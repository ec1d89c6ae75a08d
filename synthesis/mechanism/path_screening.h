#pragma once
/// \file
/// How well candidates could follow a path: many of them at once, with everything eliminated that enters linearly.
///
/// With complex numbers a guided point passes O + A p_i + B w_i at crank angle i, where p_i is the pin of the guiding
/// link and w_i its direction, both known from link lengths and crank angles, O is the origin, A size and tilt, and B
/// the point on the link, size and tilt included. The least sum of |P_i - O - A p_i - B w_i|^2 over O, A and B follows
/// from the second moments of p, w and the targets P (variable projection), so that a candidate is three ratios of
/// lengths and its crank angles.

#include <array>
#include <cstddef>
#include <span>

#include "analysis/geometry/vector.h"
#include "analysis/numbers/instruction_set.h"

namespace mechwright {

/// What the path leaves open.
struct PathFreedom {
    bool origin;  ///< O is free; else the targets are counted from it
    bool size;    ///< |A| is free; else 1
    bool tilt;    ///< the direction of A is free; else `tilted`
    Vector<double> tilted{1, 0};
    double body_length = 0;  ///< of a guided body that may stand at any angle on its link
};

/// A target with the half of the crank angle at which it is met as (cos, sin), the same for all candidates of a call.
struct ScreenedPoint {
    Vector<double> target;
    double weight;
    Vector<double> half;
    Vector<double> facing{1, 0};  ///< the direction of a guided body; (0, 0) where any will do
};

/// Eight numbers, one for each candidate of a group.
using Group = std::array<double, 8>;

/// What is left of a group of candidates: infinite where one does not assemble at every target.
struct Screened {
    Group score;  ///< the part of the weighted sum of squares of the targets (about their mean where O is free)
    Group size;   ///< the factor |A| by which the lengths have to be multiplied for it
};

/// The screening of a mechanism, in the instruction set asked for. `lengths` are the lengths that it names first.
using PathScreening = Screened (*)(InstructionSet, std::size_t assembly, std::span<const Group> lengths,
                                   std::span<const ScreenedPoint> points, const PathFreedom& free);

}  // namespace mechwright
