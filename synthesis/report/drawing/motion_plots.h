#pragma once
/// \file
/// The motion of a design as curves over the crank angle, sorted into plots: the error of a function or the distance
/// from a line or an arc; position, velocity, acceleration, jerk, transmission or pressure angle, curvature.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/report/drawing/finished.h"

namespace mechwright {

struct MotionCurve {
    std::string name;            ///< "ram-velocity"
    std::vector<double> values;  ///< in the units of the plot; NaN where there is none
};

/// A level that the curves of a plot must keep, or that they reach.
struct PlotLevel {
    std::string name;
    double value;
};

struct MotionPlot {
    std::string title;  ///< "velocity"
    std::string unit;   ///< "mm/rad"; empty for plain numbers
    std::vector<MotionCurve> curves;
    std::vector<PlotLevel> levels;
};

struct MotionPlots {
    std::string angle_name;  ///< "crank-angle"
    std::string angle_unit;
    std::vector<double> angles;  ///< in the problem's unit
    std::vector<MotionPlot> plots;
};

/// The plots at `steps` + 1 even crank angles. Velocities and accelerations are those for unit crank speed; angles go
/// on beyond a full turn instead of jumping. Levels are the limits of the document's requirements and the value of its
/// objective, where a plot shows what they are about.
MotionPlots motion_plots(const FinishedDesign& design, const nlohmann::ordered_json& document, int steps);

/// The quantities whose limits are drawn as levels.
std::vector<std::string_view> quantities_with_levels();

/// All plots in one picture, two beside each other, as a script for gnuplot.
std::string plots_script(const MotionPlots& plots);

/// How high that picture is for a width.
int plots_height(const MotionPlots& plots, int width);

}  // namespace mechwright
