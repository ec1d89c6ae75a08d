#pragma once
/// \file
/// What a document says was asked for, against the problem file that it is the answer to.

#include <nlohmann/json.hpp>
#include <vector>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// Where a document is the answer to another problem than this one: the first member that differs, with both values;
/// empty where it is the answer to this one. Numbers may differ by the rounding of a unit.
std::string asked_otherwise(const nlohmann::ordered_json& document, const Problem& problem);

/// Whether the text of the problem has the checksum that is stated, and asks for what the document says. None for a
/// document without such a text: what it says was asked for then stands for itself.
std::vector<Check> check_asked(const nlohmann::ordered_json& document);

}  // namespace mechwright
