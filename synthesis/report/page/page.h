#pragma once
/// \file
/// A page on results for any browser: one HTML file that needs no network. With scripts the mechanism moves and the
/// plots follow; without them it shows the drawing, the tables and the plots as pictures.

#include <string>
#include <vector>

#include "synthesis/report/page/shown_design.h"

namespace mechwright {

/// A result as the page shows it: what there is to say of the run, and its designs, the best first.
struct ResultToShow {
    std::string title;
    std::string file;
    nlohmann::ordered_json document;
    std::vector<DesignToShow> designs;  ///< empty where none was found
    std::size_t not_shown = 0;          ///< further alternatives
};

/// A result of which only a line is shown.
struct ResultLine {
    std::string file;
    std::string title;
    std::string standing;  ///< status and objective, or why it is not shown
};

/// One of a study's points behind a chart.
struct ChartPoint {
    std::vector<double> at;                      ///< x and y of every chart; NaN where it is not in that chart
    std::vector<nlohmann::ordered_json> values;  ///< of the study's columns: what was given and what came of it
    long design = -1;                            ///< index into the designs; -1: the page does not hold it
};

/// A chart of a study: a picture, and where its axes are in it.
struct PageChart {
    std::string title;
    std::string svg;
    double left, right, bottom, top;  ///< shares of the picture's width and height, from the left and from the top
    double x_from, x_to, y_from, y_to;
    bool logarithmic = false;  ///< in x
};

struct StudyToShow {
    std::vector<PageChart> charts;
    std::vector<std::string> columns;  ///< names of the points' values
    std::vector<ChartPoint> points;
    std::vector<DesignToShow> designs;
    std::string standing;
    std::string text;  ///< tables as for a terminal
};

struct Page {
    std::string title;
    std::vector<ResultToShow> results;
    std::vector<ResultLine> lines;
    StudyToShow study;
    bool static_plots = true;  ///< plots of the first design as a picture (with gnuplot)
};

/// The HTML. Throws ChartFault where static plots are asked for and gnuplot cannot draw.
std::string page_text(const Page& page);

}  // namespace mechwright
