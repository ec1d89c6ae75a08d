#pragma once
/// \file
/// The runs of searches that end by chance, read from their table.

#include <map>
#include <string>
#include <vector>

#include "synthesis/bench/section.h"

namespace mechwright::bench {

/// One seed: evaluations of the whole run and until each target that it came to. A gradient and a Hessian count as many
/// values as they were measured to cost.
struct Run {
    double whole = 0;
    std::map<std::string, double> until;
};

/// All seeds of one search of one problem.
struct Runs {
    std::string problem;
    std::string search;
    double variables = 0;
    std::vector<Run> runs;

    int successes(const std::string& target) const;
    /// All evaluations of all runs, those of a run that comes there only until then, over the number of those.
    double expected_evaluations(const std::string& target) const;
};

inline constexpr const char* whole_run = "whole run";
inline constexpr const char* cost_of_one = "cost of one";

std::vector<Runs> runs_of(const Sheet& sheet);

}  // namespace mechwright::bench
