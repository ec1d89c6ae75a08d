#pragma once
/// \file
/// Functions, lines and arcs in documents: one of a sort as an object, several as a list in which each has its name.

#include <nlohmann/json.hpp>

#include "synthesis/document/claim.h"
#include "synthesis/document/claim_json.h"
#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// Sets the members `function`, `line` and `arc` of a document to what the problem asks for, and where there is a
/// design to how it does that.
void put_over_input(nlohmann::ordered_json& json, const Problem& problem, const Design* design);

/// An object with what each says first, where it has a name: that and its weight.
nlohmann::ordered_json named(const InputTask& task);

namespace claims {

/// Reads the functions, lines and arcs of a document.
void read_over_input(Reader& in, const Json& document, Claim& claim);

}  // namespace claims

}  // namespace mechwright
