#pragma once
/// \file
/// What a problem with a path minimises, and whether least squares lead there.

#include "synthesis/problem/problem.h"

namespace mechwright {

/// Whether the sum of squared distances from the path is all that a problem with a path minimises; what it requires
/// besides goes along.
bool least_squares_suffice(const Problem& problem);

/// Whether the greatest distance from the path is all that it minimises: its best designs lie near those of least
/// squares.
bool least_squares_lead_on(const Problem& problem);

}  // namespace mechwright
