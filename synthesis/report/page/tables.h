#pragma once
/// \file
/// The tables of a page, as HTML with everything escaped.

#include <nlohmann/json.hpp>
#include <string>

namespace mechwright {

/// Of the document of a result or an analysis: dimensions; requirements with what is reached and the margin to each
/// limit; objective, quantities, targets with their errors; verification and search as far as they are there. Members
/// that are missing or of another type than they should be are passed over.
std::string tables_of(const nlohmann::ordered_json& document);

/// A sentence on what came of a run.
std::string standing_sentence(const nlohmann::ordered_json& document);

/// Text of a JSON value for reading: numbers with eight digits, strings as they are.
std::string cell_text(const nlohmann::ordered_json& value);

/// One row of a table; cells are plain texts, the first is its heading. A bad row stands out.
std::string table_row(const std::vector<std::string>& cells, bool bad = false);

/// A table of rows with a caption, and the heads of its columns (plain texts); empty where there are no rows.
std::string table_of(std::string_view caption, const std::vector<std::string>& heads, const std::string& rows);

}  // namespace mechwright
