#pragma once
/// \file
/// Diagrams of a few curves, drawn by gnuplot.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mechwright::bench {

struct Curve {
    std::string title;
    std::vector<std::pair<double, double>> points;  ///< those that are not finite are left out
    std::optional<std::size_t> colour{};            ///< that of curve number so and so; else one of its own
};

struct Diagram {
    std::string name;  ///< of its file, without the ending
    std::string title;
    std::string x;  ///< what stands along the axes
    std::string y;
    bool log_x = false;
    bool log_y = false;
    /// How points are joined: by lines, by steps (profiles), or not at all.
    enum class Joined { by_lines, by_steps, not_at_all } joined = Joined::by_lines;
    std::vector<Curve> curves;
};

/// The script that draws it; the size and kind of the picture are not its business. Points at or below zero do not
/// appear on a logarithmic axis.
std::string gnuplot_script(const Diagram& diagram);

}  // namespace mechwright::bench
