#pragma once
/// \file
/// JSON as text that people can read too.

#include <nlohmann/json.hpp>
#include <string>

namespace mechwright {

/// Indented by two; a list of plain values, such as a point, stays on one line. Numbers are the shortest that read back
/// as the same; bytes that are not UTF-8 are replaced. Ends with a line break.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace mechwright
