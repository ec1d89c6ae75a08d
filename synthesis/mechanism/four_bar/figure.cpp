#include "synthesis/mechanism/four_bar/figure.h"

#include <numbers>

#include "synthesis/mechanism/drawing/motion_row.h"

namespace mechwright {

namespace {

using namespace figure;

using Shared = std::shared_ptr<const Mechanism>;

constexpr double degree = std::numbers::pi / 180;

std::vector<FigurePlace> pins() {
    return {pivot("A0", 0), pivot("B0", 1), pin("A", "crank", 1), pin("B", "rocker", 1)};
}

std::vector<FigurePlace> pins_and(std::vector<FigurePlace> more) {
    std::vector<FigurePlace> all = pins();
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

FigurePanel links(const Shared& m) {
    FigurePanel panel{.title = "The links and the coupler point",
                      .design = figure_design(m, {{"ground", 100},
                                                  {"crank", 38},
                                                  {"coupler", 92},
                                                  {"rocker", 72},
                                                  {"point-along", 48},
                                                  {"point-across", 40}}),
                      .input = 70 * degree};
    panel.design.guides_point = true;
    panel.places = pins_and({point("P", "coupler")});
    panel.dimensions = {length("ground", "A0", "B0", -40),
                        length("crank", "A0", "A", 24),
                        length("coupler", "A", "B", -22),
                        length("rocker", "B0", "B", -24),
                        by("P", coordinate("point-along", "A", "P", side("A", "B"), 22)),
                        by("P", coordinate("point-across", "A", "P", side("A", "B", 90), -26))};
    return panel;
}

FigurePanel placement(const Shared& m) {
    FigurePanel panel{.title = "In the drawing, for [path] and [poses]",
                      .design = figure_design(m, {{"ground", 100},
                                                  {"crank", 44},
                                                  {"coupler", 92},
                                                  {"rocker", 78},
                                                  {"point-along", 30},
                                                  {"point-across", 34},
                                                  {"origin-x", 50},
                                                  {"origin-y", 34},
                                                  {"tilt", 25},
                                                  {"crank-start", 78},
                                                  {"body-angle", 55}}),
                      .input = 78 * degree};
    panel.design.guides_point = panel.design.guides_body = true;
    panel.places = pins_and({point("P", "coupler"), origin(), corner("ahead", "coupler", 1, 1)});
    panel.dimensions = {coordinate("origin-x", "O", "A0", x_axis(), -26),
                        coordinate("origin-y", "O", "A0", y_axis(), 26),
                        angle("tilt", "A0", x_axis(), side("A0", "B0"), 100),
                        angle("crank-start", "A0", side("A0", "B0"), side("A0", "A"), 42),
                        angle("body-angle", "P", side("A", "B"), side("P", "ahead"), 48)};
    panel.remark = "The arrow at P is the direction in which a guided body faces.";
    return panel;
}

FigurePanel function(const Shared& m) {
    constexpr double start = 35, range = 70;
    FigurePanel panel{.title = "Scales of [function]; the input also of [line] and [arc]",
                      .design = figure_design(m, {{"ground", 100},
                                                  {"crank", 52},
                                                  {"coupler", 80},
                                                  {"rocker", 78},
                                                  {"input-start", start},
                                                  {"input-range", range}}),
                      .input = start * degree,
                      .end = (start + range) * degree};
    const auto rocker = [&](double input) { return MotionRow(panel.design, input)["rocker-angle"]; };
    const auto set = [&](const char* name, double value) {
        panel.design.dimensions[static_cast<std::size_t>(find_dimension(*m, name))] = value;
    };
    set("output-start", rocker(panel.input));
    set("output-range", rocker(*panel.end) - rocker(panel.input));
    panel.places = pins_and({at_end(pin("A'", "crank", 1)), at_end(pin("B'", "rocker", 1))});
    panel.dimensions = {angle("input-start", "A0", side("A0", "B0"), side("A0", "A"), 52),
                        angle("input-range", "A0", side("A0", "A"), side("A0", "A'"), 78),
                        angle("output-start", "B0", side("A0", "B0"), side("B0", "B"), 46),
                        angle("output-range", "B0", side("B0", "B"), side("B0", "B'"), 82)};
    panel.remark = "The faint position is the one at the end of the range.";
    return panel;
}

FigurePanel line(const Shared& m) {
    FigurePanel panel{.title = "What the coupler point follows: [line]",
                      .design = figure_design(m, {{"ground", 40},
                                                  {"crank", 20},
                                                  {"coupler", 50},
                                                  {"rocker", 50},
                                                  {"point-along", 100},
                                                  {"origin-x", -45},
                                                  {"origin-y", -30},
                                                  {"tilt", 20},
                                                  {"input-start", 110},
                                                  {"input-range", 140},
                                                  {"line-angle", 20},
                                                  {"line-offset", 67.2}}),
                      .input = 140 * degree};
    panel.design.guides_point = true;
    panel.design.motion.followed = Followed::line;
    panel.shows_paths = true;
    panel.places = pins_and(
        {point("P", "coupler"), origin(), of_target("foot", PlaceOf::line_foot), of_target("end", PlaceOf::line_end)});
    panel.dimensions = {angle("line-angle", "foot", x_axis(), side("foot", "end"), 60),
                        coordinate("line-offset", "O", "foot", side("foot", "end", 90), 0)};
    return panel;
}

FigurePanel arc(const Shared& m) {
    FigurePanel panel{.title = "What the coupler point follows: [arc]",
                      .design = figure_design(m, {{"ground", 100},
                                                  {"crank", 38},
                                                  {"coupler", 92},
                                                  {"rocker", 72},
                                                  {"point-along", 48},
                                                  {"point-across", 40},
                                                  {"origin-x", 30},
                                                  {"origin-y", 25},
                                                  {"input-start", 100},
                                                  {"input-range", 120},
                                                  {"arc-x", 73.53},
                                                  {"arc-y", 54.61},
                                                  {"arc-radius", 64.98}}),
                      .input = 150 * degree};
    panel.design.guides_point = true;
    panel.design.motion.followed = Followed::arc;
    panel.shows_paths = true;
    panel.places = pins_and(
        {point("P", "coupler"), origin(), of_target("M", PlaceOf::arc_centre), of_target("end", PlaceOf::arc_end)});
    panel.dimensions = {coordinate("arc-x", "O", "M", x_axis(), -26), coordinate("arc-y", "O", "M", y_axis(), 26),
                        length("arc-radius", "M", "end", 0)};
    return panel;
}

}  // namespace

std::vector<FigurePanel> four_bar_figure(const Shared& mechanism) {
    return {links(mechanism), placement(mechanism), function(mechanism), line(mechanism), arc(mechanism)};
}

}  // namespace mechwright
