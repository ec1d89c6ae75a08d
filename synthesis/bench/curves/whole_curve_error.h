#pragma once
/// \file
/// What a four-bar misses a shape by, for searches other than ours: a function of numbers between 0 and 1.

#include <array>
#include <memory>
#include <span>

#include "synthesis/bench/curves/shapes.h"
#include "synthesis/search/curve/descent.h"

namespace mechwright::bench {

/// The program's own measure of a shape: root mean square of the distances from its points to the nearest points of
/// the whole coupler curve, by the functions that the program's search calls.
struct WholeCurveError {
    std::shared_ptr<const Problem> problem;
    std::shared_ptr<const std::vector<Program>> programs;
    CurveProblem curve;

    /// Of these arguments (CurveArguments) in an assembly, in mm. Infinite where no such design is allowed: a closed
    /// shape is for a crank that turns fully.
    double at(const CurveArguments& arguments, std::size_t assembly, CurveWork& work) const;
    /// Of a point of the unit box: the nine dimensions as parts of their ranges, then the assembly, crossed from 1/2.
    double at(std::span<const double> part, CurveWork& work) const;
    /// The program's unit of length in mm.
    double unit() const { return programs->front().length; }
};

inline constexpr std::size_t unit_box_size = 10;

/// Of a shape without requirements.
WholeCurveError whole_curve_error(const Shape& shape);

}  // namespace mechwright::bench
