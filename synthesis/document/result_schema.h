#pragma once
/// \file
/// What a result document says, as a JSON Schema.

#include <nlohmann/json.hpp>

namespace mechwright {

/// Of a result document, or a list of them, made from the list that they are written by (fields.h) and from the
/// mechanisms.
nlohmann::ordered_json result_schema();

}  // namespace mechwright
