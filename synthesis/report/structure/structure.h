#pragma once
/// \file
/// How a linkage is made up and in which order it is placed, for people and for programs.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "synthesis/problem/linkage/linkage.h"

namespace mechwright {

/// Links, joints, mobility, drives, groups in solving order; where all dimensions are given and all groups are dyads
/// all assemblies at an input of the master (radians, or a displacement), by default that which the file names, or 0,
/// or the middle of what a slide or stops allow; and all circuits with their branches.
nlohmann::ordered_json structure_of(const Linkage& linkage, std::optional<double> at);

/// The same as text.
std::string structure_text(const Linkage& linkage, std::optional<double> at, bool colour);

}  // namespace mechwright
