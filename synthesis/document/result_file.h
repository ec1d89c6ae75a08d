#pragma once
/// \file
/// Result documents in files, as JSON that may be anything.

#include <nlohmann/json.hpp>
#include <string>

namespace mechwright {

/// Why JSON is not a result document of this program; empty if it is one.
std::string why_not_a_result(const nlohmann::ordered_json& json);

struct ReadJson {
    nlohmann::ordered_json json;
    std::string fault;        ///< why there is none; empty if all is well
    bool unreadable = false;  ///< the file cannot be read; else it is not JSON
};

/// Reads a file of one result document, or a list of them.
ReadJson read_result_file(const std::string& file);

}  // namespace mechwright
