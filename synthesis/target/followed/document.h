#pragma once
/// \file
/// What is said of a line or an arc that a guided point follows beside the design.

#include <nlohmann/json.hpp>

#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// {full_turn}; with a design also extremes: [{crank_angle, distance}], `alternating` and `free` as for a function.
nlohmann::ordered_json followed_document(const Problem& problem, const InputTask& task, const Design* design);

}  // namespace mechwright
