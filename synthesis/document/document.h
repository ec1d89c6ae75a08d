#pragma once
/// \file
/// The result document: everything there is to say about a run, as JSON. All angles are in the file's unit. Its members
/// are those of fields.h; `mechwright schema result` prints them as a JSON Schema.

#include <nlohmann/json.hpp>
#include <string>

#include "synthesis/program/result.h"

namespace mechwright {

/// The document of a result. Verification is included as far as the result has it.
nlohmann::ordered_json document(const Problem& problem, const Result& result);

/// The document of a design that was given: as above, without what only a search has (status, verification,
/// alternatives, search).
nlohmann::ordered_json analysis_document(const Problem& problem, const Solution& solution);

/// What a problem asks for as the document states it: everything that does not follow from the design.
nlohmann::ordered_json asked_document(const Problem& problem);

/// The member verification: passed, checks.
nlohmann::ordered_json verification_document(const std::vector<Check>& done);

/// The status as the document writes it.
std::string_view name_of(Status status);

}  // namespace mechwright
