#pragma once
/// \file
/// The circuits and branches of a linkage whose dimensions are all given, as `mechwright structure` lists them.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "synthesis/problem/linkage/linkage.h"

namespace mechwright {

/// A list of circuits, each with its branches: their sides, from where to where they go, and what ends them. Null where
/// the master's inputs are no cycle of `most_turns` or fewer, or too many sides are possible to look at them all.
nlohmann::ordered_json circuits_of(const Linkage& linkage);

/// The same as text.
std::string circuits_text(const Linkage& linkage, const nlohmann::ordered_json& circuits);

}  // namespace mechwright
