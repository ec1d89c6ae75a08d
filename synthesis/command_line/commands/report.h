#pragma once
/// \file
/// Pages as the commands write them.

#include <string>

#include "synthesis/command_line/console.h"
#include "synthesis/report/page/results_page.h"

namespace mechwright {

/// Writes a page, without plots for browsers without scripts where gnuplot cannot draw them, and says so. Returns the
/// exit code.
int write_page(Page page, const std::string& out, bool quiet, Console& console);

}  // namespace mechwright
