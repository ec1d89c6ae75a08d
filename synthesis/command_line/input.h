#pragma once
/// \file
/// Problem files as the commands take them.

#include <string>

#include "synthesis/command_line/console.h"
#include "synthesis/problem/linkage/linkage.h"
#include "synthesis/problem/reader.h"

namespace mechwright {

/// Reads and checks a file, reports everything that is wrong with it (warnings too, unless `quiet`), and returns the
/// exit code: 0, invalid_file or no_access.
int read_and_report(const std::string& file, bool quiet, Console& console, ReadProblem& read);

/// The same for a file of a linkage.
int read_and_report(const std::string& file, bool quiet, Console& console, ReadLinkage& read);

/// Reports what is wrong with the method that the file names, and returns the exit code: 0 or invalid_file.
int report_method_fault(const Problem& problem, Console& console);

}  // namespace mechwright
