#pragma once

#include <fmt/format.h>

#include <string>

#include "synthesis/solve/solve.h"

namespace mechwright {

/// Ranges of all dimensions of a four-bar with a coupler point, as they stand in [dimensions]: lengths up to `most`.
inline std::string free_four_bar(int most) {
    std::string text;
    for (const char* length : {"ground", "crank", "coupler", "rocker"})
        text += fmt::format("{:<12} = {{ min = 0, max = {} }}\n", length, most);
    for (const char* coordinate : {"point-along", "point-across", "origin-x", "origin-y"})
        text += fmt::format("{:<12} = {{ min = {}, max = {} }}\n", coordinate, -most, most);
    return text + "tilt         = { min = 0, max = 360 }\nassembly     = \"either\"\n";
}

inline Result all_solutions(const Problem& problem) {
    RunOptions options;
    options.all = true;
    options.jobs = 2;
    return solve(problem, options);
}

}  // namespace mechwright
