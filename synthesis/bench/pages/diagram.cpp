#include "synthesis/bench/pages/diagram.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "synthesis/report/csv/csv_text.h"
#include "synthesis/report/files/gnuplot.h"

namespace mechwright::bench {

namespace {

// Colours that differ in brightness too, and with them the shapes of the points (Okabe and Ito's palette).
constexpr std::array<std::string_view, 8> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#000000", "#8c6d31"};

std::string_view colour_of(std::size_t curve) { return colours[curve % colours.size()]; }

std::string_view style_of(const Diagram& diagram) {
    switch (diagram.joined) {
        case Diagram::Joined::by_steps: return "steps";
        case Diagram::Joined::not_at_all: return "points";
        default: return "linespoints";
    }
}

bool drawable(const Diagram& diagram, const std::pair<double, double>& point) {
    return std::isfinite(point.first) && std::isfinite(point.second) && (!diagram.log_x || point.first > 0) &&
           (!diagram.log_y || point.second > 0);
}

}  // namespace

std::string gnuplot_script(const Diagram& diagram) {
    std::string script;
    std::string plots;
    for (std::size_t i = 0; i < diagram.curves.size(); ++i) {
        std::string points;
        for (const auto& point : diagram.curves[i].points)
            if (drawable(diagram, point))
                points += fmt::format("{} {}\n", csv_number(point.first), csv_number(point.second));
        if (points.empty()) continue;
        script += fmt::format("$curve{} << EOD\n{}EOD\n", i, points);
        const bool points_wanted = diagram.joined != Diagram::Joined::by_steps;
        plots +=
            fmt::format("{} $curve{} using 1:2 with {} lw 1.6 {} lc rgb '{}' title {}", plots.empty() ? "plot" : ",", i,
                        style_of(diagram), points_wanted ? fmt::format("pt {} ps 0.6", i % 15 + 1) : "",
                        colour_of(diagram.curves[i].colour.value_or(i)), gnuplot_text(diagram.curves[i].title));
    }
    script += fmt::format("set title {} font ',12'\nset xlabel {}\nset ylabel {}\n", gnuplot_text(diagram.title),
                          gnuplot_text(diagram.x), gnuplot_text(diagram.y));
    if (diagram.log_x) script += "set logscale x\nset format x '%h'\n";
    if (diagram.log_y) script += "set logscale y\nset format y '%h'\n";
    script +=
        "set border 3 lc rgb '#444444'\nset tics nomirror out font ',10'\nset grid lc rgb '#dddddd'\n"
        "set key outside right top font ',10' spacing 1.2\n";
    return script + plots + "\n";
}

}  // namespace mechwright::bench
