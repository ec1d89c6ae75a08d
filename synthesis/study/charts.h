#pragma once
/// \file
/// Pictures of a study's data, for gnuplot.

#include <filesystem>
#include <string>
#include <vector>

#include "synthesis/problem/problem.h"
#include "synthesis/problem/study/study.h"

namespace mechwright {

/// Where the axes of a chart are: their ends, and the place of the plot in the picture, as shares of its width and
/// height counted from the lower left.
struct ChartFrame {
    double x_from = 0, x_to = 1, y_from = 0, y_to = 1;
    double right = 0.84;  ///< less where there is a legend
    static constexpr double left = 0.12, bottom = 0.14, top = 0.9;
};

/// A picture as a gnuplot script with its data in it; the terminal is left to whoever runs it.
struct ChartScript {
    std::string name;
    std::string title;
    std::string script;
    ChartFrame frame;
    std::string upwards;  ///< the column that goes up; `x` of the chart goes to the right
    std::string where;    ///< SQL: the points that are in it
};

/// The charts that the study asks for; where it asks for none, one is chosen: a map over the first two axes of numbers,
/// or curves over the only one.
std::vector<StudyChart> charts_of(const Problem& problem);

/// The scripts of a chart: one, or one for each value of its column `each`. Throws ChartFault.
std::vector<ChartScript> chart_scripts(const std::filesystem::path& data, const Problem& problem,
                                       const StudyChart& chart);

}  // namespace mechwright
