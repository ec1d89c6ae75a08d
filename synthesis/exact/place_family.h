#pragma once
/// \file
/// Four-bars that pass fewer places than say which it is. The directions in which the coupler may face at some of the
/// points choose a member of their family: with these given the four-bars are finitely many again.

#include <cstddef>

#include "synthesis/exact/exact_designs.h"
#include "synthesis/program/run_end.h"
#include "synthesis/program/run_options.h"

namespace mechwright {

/// A four-bar that guides a body has as many dimensions that places can say: a pose says two, a point one.
inline constexpr std::size_t conditions_of_four_bar = 10;

/// How many of them the places of a path say. Of points alone the first takes the place of a pose.
std::size_t conditions_said_by(const PathTarget& path);

/// How many directions can be chosen; 0 where the four-bars are finitely many.
std::size_t free_directions(const PathTarget& path);

/// The best members of the family. Precondition: there are two places or more, and directions to be chosen.
ExactDesigns place_family_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
