#pragma once
/// \file
/// Subplex by NLopt 2.7.1, for functions without derivatives in the unit cube.

#include <functional>
#include <vector>

namespace mechwright {

/// A function of numbers in (0, 1) to be minimised, and whether it is time to end.
struct CubeFunction {
    std::function<double(const std::vector<double>&)> value;
    std::function<bool()> ended;
};

/// The point that a run of at most so many evaluations ends at. The solver's word is not passed on: the caller
/// evaluates the point, and keeps the start where that is better. Thread-safe.
std::vector<double> subplex(const CubeFunction& function, std::vector<double> start, int most_evaluations);

}  // namespace mechwright
