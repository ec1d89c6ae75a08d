#pragma once

#include "synthesis/solve/solve.h"

namespace mechwright {

inline Result all_solutions(const Problem& problem) {
    RunOptions options;
    options.all = true;
    options.jobs = 2;
    return solve(problem, options);
}

}  // namespace mechwright
