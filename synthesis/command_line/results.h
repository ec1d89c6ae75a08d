#pragma once
/// \file
/// The files that results are written to.

#include <optional>
#include <string>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// A name without extension for the results of each problem file: its own, with "-2", "-3", ... where another file has
/// it already.
std::vector<std::string> result_names(const std::vector<std::string>& files);

/// Makes the folder ready for the results of these names before anything is computed. Returns what stands in the way.
std::optional<std::string> prepare_results(const std::string& folder, const std::vector<std::string>& names,
                                           const std::vector<std::string>& table_endings);

/// A table beside a result: what the name of its file ends in, and its text.
struct ResultTable {
    std::string ending;
    std::string text;
};

/// The files of one result: the text of its document, and tables.
struct ResultText {
    std::string document;
    std::vector<ResultTable> tables;
};

/// Writes them. Returns what went wrong.
std::optional<std::string> write_result(const std::string& folder, const std::string& name, const ResultText& text);

}  // namespace mechwright
