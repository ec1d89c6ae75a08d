#pragma once
/// \file
/// What a document states of the extremes of an error and of their alternation, derived again in fifty digits.

#include <nlohmann/json.hpp>
#include <vector>

#include "synthesis/document/claim.h"
#include "synthesis/problem/input_tasks.h"

namespace mechwright {

/// Of a function, a line or an arc of a document, whose `stated` member {extremes, alternating, free} this is: that
/// the extremes are where they are stated, that so many of them are as great as the greatest and follow each other with
/// alternating signs, and that the error depends on so many free dimensions independently. Where more alternate than
/// are free, and nothing but the least error is asked for, that weights > 0 of these extremes balance: no small change
/// of the dimensions makes all of them smaller. None of a design that comes apart, which other checks say.
std::vector<Check> check_alternation(const nlohmann::ordered_json& stated, const Claim& claim, const InputTask& task);

}  // namespace mechwright
