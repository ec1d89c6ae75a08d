#pragma once
/// \file
/// What a result document says of a cam beside its dimensions.

#include <nlohmann/json.hpp>
#include <string>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// {follower, motion, [contour], segments: [{kind, [laws], [start, end, shape], [points]}]}: what was given. start, end
/// and shape count the numbers of a polynomial, points are [cam angle, lift]. Precondition: the problem is that of a
/// cam.
nlohmann::ordered_json cam_document(const Problem& problem);

/// Adds rotation and laws (one name for each segment, empty where it has none) to a design.
void put_cam_choice(nlohmann::ordered_json& design, const Problem& problem, std::size_t assembly);

/// "turning counter-clockwise; laws cycloidal, 3-4-5": what was chosen, in words.
std::string cam_choice_text(const Problem& problem, std::size_t assembly);

}  // namespace mechwright
