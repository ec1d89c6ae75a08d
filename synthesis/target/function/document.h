#pragma once
/// \file
/// What is said of a generated function beside the design: the function itself, and where its error is extreme.

#include <nlohmann/json.hpp>

#include "synthesis/document/claim.h"
#include "synthesis/document/claim_json.h"
#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// {expression, x | samples}: what was given; with a design also extremes: [{x, error}], `alternating`: how many of
/// those as great as the greatest follow each other with alternating signs, and `free`: how many dimensions were free
/// to make it small. Angles in the problem's unit.
nlohmann::ordered_json function_document(const Problem& problem, const InputTask& task, const Design* design);

namespace claims {

/// Reads a function of a document; null where it is not understood. `place` is what messages call it.
std::shared_ptr<const FunctionTarget> read_function(Reader& in, const Json& json, const std::string& place);

}  // namespace claims

}  // namespace mechwright
