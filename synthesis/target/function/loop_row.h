#pragma once
/// \file
/// The loop equation of a function generator, linear in three constants of the mechanism: at an input and an output
///
///     row[0] k1 + row[1] k2 + row[2] k3 = row[3]
///
/// (Freudenstein's equation for the four-bar; Theory of Machines, chapter 9). Least squares of it give a start for
/// synthesis, its determinants a bound for every mechanism of the kind.

#include <array>
#include <optional>
#include <span>

#include "synthesis/target/function/function_target.h"

namespace mechwright {

/// The four numbers at an input and an output, and their derivatives by both. T is a number or an interval.
template <class T>
struct LoopRow {
    std::array<T, 4> value;
    std::array<T, 4> by_input;
    std::array<T, 4> by_output;
};

/// The constants that meet the equation best over a function's range, in the mean square; nothing where none are
/// finite. `scales` are start and range of the input, then of the output.
std::optional<std::array<double, 3>> loop_constants(const FunctionTarget& f, std::span<const double> scales,
                                                    LoopRow<double> (*row)(const double& input, const double& output));

}  // namespace mechwright
