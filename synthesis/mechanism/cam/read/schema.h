#pragma once
/// \file
/// What the schema of problem files says of cams beside the lists of keys.

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// Names of laws of motion, then other names for some of them.
std::vector<std::string_view> cam_law_names();

/// Laws and ends of segments.
void complete_cam_schema(nlohmann::ordered_json& properties);

/// Files of a cam with this follower, which moves so, and has this contour or none.
nlohmann::ordered_json is_cam_of(const Mechanism& mechanism);

/// A cam moves by its segments, or by its contour, through a whole turn.
void limit_cam_files(const Mechanism& mechanism, nlohmann::ordered_json& schema);

}  // namespace mechwright
