#pragma once
/// \file
/// Pictures of a study's data, drawn by gnuplot.

#include <filesystem>
#include <stdexcept>
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

/// What is wrong with a chart: a column that the data do not have, or nothing to draw.
struct ChartFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The charts that the study asks for; where it asks for none, one is chosen: a map over the first two axes of numbers,
/// or curves over the only one.
std::vector<StudyChart> charts_of(const Problem& problem);

/// The scripts of a chart: one, or one for each value of its column `each`.
std::vector<ChartScript> chart_scripts(const std::filesystem::path& data, const Problem& problem,
                                       const StudyChart& chart);

enum class PictureFormat { svg, png };

/// The picture that gnuplot makes of a script in a file. Throws ChartFault where there is no gnuplot or it fails.
std::string drawn(const std::filesystem::path& script, PictureFormat format);

}  // namespace mechwright
