#pragma once
/// \file
/// Four-bars, slider-cranks and inverted slider-cranks that pass fewer places than say which it is. The directions in
/// which the coupler may face at some of the points choose a member of their family: with these given the linkages are
/// finitely many again.

#include <cstddef>

#include "synthesis/exact/exact_designs.h"
#include "synthesis/exact/guided_parts.h"
#include "synthesis/exact/homotopy/guidance_solutions.h"
#include "synthesis/program/run_end.h"
#include "synthesis/program/run_options.h"

namespace mechwright {

/// How many conditions (guided_parts.h) the places of a path say. Of points alone the first takes the place of a pose.
std::size_t conditions_said_by(const PathTarget& path);

/// How many directions can be chosen; 0 where the linkages are finitely many.
std::size_t free_directions(const Problem& problem);

/// The design of a real solution for places; nothing where a link has no length.
std::optional<ExactDesign> exact_design(const Problem& problem, const homotopy::GuidanceTarget& target,
                                        const homotopy::GuidanceValues& solution);

/// The best members of the family. Precondition: there are two places or more, and directions to be chosen.
ExactDesigns place_family_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

}  // namespace mechwright
