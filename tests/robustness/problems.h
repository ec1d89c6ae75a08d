#pragma once
/// \file
/// Shipped problems for the tests of robustness, and what is left of a result without its times.

#include <string>
#include <vector>

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {

inline std::string problem_file(const std::string& name) { return MECHWRIGHT_SOURCE_DIR "/problems/" + name + ".toml"; }

inline std::vector<std::string> problem_files(const std::vector<std::string>& names) {
    std::vector<std::string> files;
    for (const std::string& name : names)
        files.push_back(problem_file(name));
    return files;
}

/// In a file before a command writes it.
constexpr const char* earlier_content = "what stood there before\n";

/// A command line followed by files.
inline std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

/// The text of result documents but for the seconds that the search took: all else counts byte for byte.
inline std::string without_seconds(const std::string& text) {
    std::istringstream lines(text);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (line.find("\"seconds\": ") == std::string::npos) kept += line + "\n";
    return kept;
}

/// A study of 21 points, or as many as are asked for, each solved by local searches.
inline std::string small_study(int points = 21) {
    return R"(schema    = 1
title     = "Drag links over their velocity ratio"
mechanism = "four-bar"

[dimensions]
ground  = 100.0
crank   = { min = 100, max = 400 }
coupler = { min = 100, max = 400 }
rocker  = { min = 100, max = 400 }

[[require]]
quantity = "velocity-ratio-max"
equal    = 2.0

[objective]
maximize = "transmission-angle-worst"

[study]
"require.velocity-ratio-max.equal" = { from = 1.5, to = 2.5, count = )" +
           std::to_string(points) + " }\n";
}

/// A study whose points are solved in no time.
inline std::string closed_form_study(int points) {
    return crank_rocker("\n[study]\n\"require.swing.equal\" = { from = 40, to = 80, count = " + std::to_string(points) +
                        " }\n");
}

}  // namespace mechwright::testing
