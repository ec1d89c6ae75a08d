#pragma once
/// \file
/// The values that a discrete dimension may have: choices, or steps.

#include <cstddef>
#include <utility>

#include "synthesis/problem/problem.h"

namespace mechwright {

inline constexpr std::size_t most_choices = 1000;  ///< of a dimension
inline constexpr double most_steps = 1e6;          ///< of a dimension, from the least value to the greatest

/// How many values are allowed, and the one with a number from 0, the least. `range` is discrete.
std::size_t count_allowed(const DimensionRange& range);
double allowed_value(const DimensionRange& range, std::size_t number);

/// The allowed value that is nearest to another. `range` is discrete.
double nearest_allowed(const DimensionRange& range, double value);

/// Two allowed values that follow each other, with another of the range between them: of an allowed value that and the
/// next one, of the greatest that before it and itself. Values outside of the range count as its ends.
std::pair<double, double> allowed_around(const DimensionRange& range, double value);

/// Makes whole steps from the least value of a range the only ones allowed; its greatest value becomes the last of
/// them, but for what rounding leaves. False, and nothing changes, where there is no step in the range or there are
/// more than most_steps.
bool end_with_step(DimensionRange& range, double step);

/// Makes the multiples of a number the only values of a range that are allowed; where there is one, it becomes that
/// number. False, and nothing changes, where there is none or there are more than most_steps.
bool round_to(DimensionRange& range, double multiple);

/// The same range with any value of it allowed.
DimensionRange continuous(DimensionRange range);

/// Part of the allowed values, both ends among them: a number where they are the same.
DimensionRange allowed_between(const DimensionRange& range, double least, double greatest);

}  // namespace mechwright
