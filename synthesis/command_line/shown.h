#pragma once
/// \file
/// Designs as the commands take them that show or export one: result documents, and problems that leave nothing open.

#include <string>

#include "synthesis/command_line/console.h"
#include "synthesis/report/drawing/finished.h"

namespace mechwright {

struct ShownDesign {
    FinishedDesign design;
    nlohmann::ordered_json document;  ///< of the result, or of the analysis of a given mechanism
    std::string title;
};

/// Reads a file, of which `alternative` counts from 1 among the alternatives of a result (0: its own design), and
/// reports what is wrong with it. Returns the exit code; a design that does not assemble is `infeasible`.
int read_shown(const std::string& file, std::size_t alternative, Console& console, ShownDesign& shown);

/// Writes what was made of a design to a file, or prints it where none is named. Returns the exit code.
int hand_over(const std::string& file, std::string_view text, Console& console);

}  // namespace mechwright
