#pragma once
/// \file
/// Plots, drawn by gnuplot.

#include <stdexcept>
#include <string>
#include <string_view>

namespace mechwright {

/// What is wrong with a chart: a column that the data do not have, nothing to draw, or no gnuplot.
struct ChartFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Picture {
    enum class Format { svg, png, gif } format = Format::svg;
    int width = 900;
    int height = 640;
    bool fixed = false;  ///< an SVG of this size in whatever it stands; else it fills that
    double delay = 0.1;  ///< seconds between the plots of a script, which are the pictures of an animated GIF
};

/// The picture that gnuplot makes of a script, which leaves the terminal to the format. Throws ChartFault where there
/// is no gnuplot or it fails.
std::string gnuplot_picture(const std::string& script, const Picture& picture);

/// A text in a gnuplot script, in single quotes: in double quotes gnuplot would run what stands between backticks.
std::string gnuplot_text(std::string_view text);

}  // namespace mechwright
