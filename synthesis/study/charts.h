#pragma once
/// \file
/// Pictures of a study's data, for gnuplot.

#include <filesystem>
#include <string>
#include <vector>

#include "synthesis/problem/problem.h"
#include "synthesis/problem/study.h"

namespace mechwright {

/// A picture as a gnuplot script with its data in it; the terminal is left to whoever runs it.
struct ChartScript {
    std::string name;
    std::string script;
};

/// The charts that the study asks for; where it asks for none, one is chosen: a map over the first two axes of numbers,
/// or curves over the only one.
std::vector<StudyChart> charts_of(const Problem& problem);

/// The scripts of a chart: one, or one for each value of its column `each`. Throws ChartFault.
std::vector<ChartScript> chart_scripts(const std::filesystem::path& data, const Problem& problem,
                                       const StudyChart& chart);

}  // namespace mechwright
