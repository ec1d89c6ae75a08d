#pragma once
/// \file
/// Pages as the commands write them.

#include <filesystem>
#include <string>
#include <vector>

#include "synthesis/command_line/console.h"
#include "synthesis/report/page/results_page.h"

namespace mechwright {

/// The results in a folder's files (*.json) but those named, by the names of the files; what is no result is passed
/// over.
NamedDocuments other_results(const std::filesystem::path& folder, const std::vector<std::string>& but);

/// Writes a page, on which files have paths that begin in its own folder, without plots for browsers without scripts
/// where gnuplot cannot draw them, and says so. Returns the exit code.
int write_page(Page page, const std::string& out, bool quiet, Console& console);

}  // namespace mechwright
