#pragma once
/// \file
/// Pages on the results in a folder, and on single results.

#include <filesystem>
#include <string>
#include <vector>

#include "synthesis/report/page/page.h"

namespace mechwright {

/// A result with the designs of it that there is room for: its own, those of its front, its alternatives.
ResultToShow result_to_show(const std::string& file, const nlohmann::ordered_json& document, std::size_t most_designs);

/// A line on a result.
ResultLine result_line(const std::string& file, const nlohmann::ordered_json& document);

/// Results with the names of their files.
using NamedDocuments = std::vector<std::pair<std::string, nlohmann::ordered_json>>;

/// The page on results in the order given, with the title of the only one or how many they are. The first hundred
/// designs are shown, that of every result before alternatives; of further results there is a line.
Page page_on_results(const NamedDocuments& results);

}  // namespace mechwright
