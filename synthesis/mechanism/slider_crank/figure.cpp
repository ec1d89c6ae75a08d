#include "synthesis/mechanism/drawing/figure.h"

#include <cmath>
#include <numbers>

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/mechanism/slider_crank/slider_crank.h"

namespace mechwright {

namespace {

using namespace figure;

using Shared = std::shared_ptr<const Mechanism>;

constexpr double degree = std::numbers::pi / 180;

/// The crank pivot, the pins, and a place on the ram that shows where its slide goes.
std::vector<FigurePlace> pins_and(std::vector<FigurePlace> more) {
    std::vector<FigurePlace> all{pivot("A0", 0), pin("A", "crank", 1), pin("B", "ram", 0),
                                 fixed("ahead", {1, 0}, "ram")};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

FigureSide slide(double turned = 0) { return side("B", "ahead", turned); }

FigurePanel links(const Shared& m) {
    FigurePanel panel{.title = "The links and the point of the rod",
                      .design = figure_design(
                          m, {{"crank", 40}, {"rod", 110}, {"offset", 28}, {"point-along", 48}, {"point-across", 36}}),
                      .input = 60 * degree};
    panel.design.guides_point = true;
    panel.places = pins_and({point("P", "rod")});
    panel.dimensions = {length("crank", "A0", "A", 24), length("rod", "A", "B", -22),
                        by("B", coordinate("offset", "A0", "B", slide(90), -44)),
                        by("P", coordinate("point-along", "A", "P", side("A", "B"), 22)),
                        by("P", coordinate("point-across", "A", "P", side("A", "B", 90), -26))};
    return panel;
}

FigurePanel placement(const Shared& m) {
    FigurePanel panel{.title = "In the drawing, for [path] and [poses]",
                      .design = figure_design(m, {{"crank", 44},
                                                  {"rod", 110},
                                                  {"offset", 10},
                                                  {"point-along", 40},
                                                  {"point-across", 34},
                                                  {"origin-x", 50},
                                                  {"origin-y", 34},
                                                  {"tilt", 25},
                                                  {"crank-start", 80},
                                                  {"body-angle", 70}}),
                      .input = 80 * degree};
    panel.design.guides_point = panel.design.guides_body = true;
    panel.places = pins_and({point("P", "rod"), origin(), corner("tip", "rod", 1, 1)});
    panel.dimensions = {coordinate("origin-x", "O", "A0", x_axis(), -26),
                        coordinate("origin-y", "O", "A0", y_axis(), 26), angle("tilt", "A0", x_axis(), slide(), 100),
                        angle("crank-start", "A0", slide(), side("A0", "A"), 42),
                        angle("body-angle", "P", side("A", "B"), side("P", "tip"), 48)};
    panel.remark = "The arrow at P is the direction in which a guided body faces.";
    return panel;
}

FigurePanel function(const Shared& m) {
    constexpr double start = 35, range = 70;
    FigurePanel panel{
        .title = "Scales of [function]; the input also of [line] and [arc]",
        .design = figure_design(
            m, {{"crank", 50}, {"rod", 100}, {"offset", 15}, {"input-start", start}, {"input-range", range}}),
        .input = start * degree,
        .end = (start + range) * degree};
    const auto ram = [&](double input) { return MotionRow(panel.design, input)["ram-position"]; };
    const auto set = [&](const char* name, double value) {
        panel.design.dimensions[static_cast<std::size_t>(find_dimension(*m, name))] = value;
    };
    set("output-start", ram(panel.input));
    set("output-range", ram(*panel.end) - ram(panel.input));
    panel.places = pins_and({at_end(pin("A'", "crank", 1)), at_end(pin("B'", "ram", 0))});
    panel.dimensions = {angle("input-start", "A0", slide(), side("A0", "A"), 52),
                        angle("input-range", "A0", side("A0", "A"), side("A0", "A'"), 78),
                        by("A0", coordinate("output-start", "A0", "B", slide(), -40)),
                        by("B", coordinate("output-range", "B", "B'", slide(), 36))};
    panel.remark =
        "The faint position is the one at the end of the range; here the ram comes back, and output-range is negative.";
    return panel;
}

FigurePanel line(const Shared& m) {
    FigurePanel panel{.title = "What the point of the rod follows: [line]",
                      .design = figure_design(m, {{"crank", 30},
                                                  {"rod", 80},
                                                  {"point-along", 35},
                                                  {"point-across", 20},
                                                  {"origin-x", -50},
                                                  {"origin-y", 20},
                                                  {"tilt", 30},
                                                  {"input-start", 60},
                                                  {"input-range", 70},
                                                  {"line-angle", 32.37},
                                                  {"line-offset", 76.56}}),
                      .input = 75 * degree};
    panel.design.guides_point = true;
    panel.design.motion.followed = Followed::line;
    panel.shows_paths = true;
    panel.places = pins_and(
        {point("P", "rod"), origin(), of_target("foot", PlaceOf::line_foot), of_target("end", PlaceOf::line_end)});
    panel.dimensions = {angle("line-angle", "foot", x_axis(), side("foot", "end"), 46),
                        coordinate("line-offset", "O", "foot", side("foot", "end", 90), 0)};
    return panel;
}

FigurePanel arc(const Shared& m) {
    FigurePanel panel{.title = "What the point of the rod follows: [arc]",
                      .design = figure_design(m, {{"crank", 40},
                                                  {"rod", 110},
                                                  {"offset", 10},
                                                  {"point-along", 50},
                                                  {"point-across", 36},
                                                  {"origin-x", -5},
                                                  {"origin-y", 40},
                                                  {"input-start", 60},
                                                  {"input-range", 120},
                                                  {"arc-x", 50.91},
                                                  {"arc-y", 29.05},
                                                  {"arc-radius", 72.21}}),
                      .input = 100 * degree};
    panel.design.guides_point = true;
    panel.design.motion.followed = Followed::arc;
    panel.shows_paths = true;
    panel.places = pins_and(
        {point("P", "rod"), origin(), of_target("M", PlaceOf::arc_centre), of_target("end", PlaceOf::arc_end)});
    panel.dimensions = {coordinate("arc-x", "O", "M", x_axis(), -26), coordinate("arc-y", "O", "M", y_axis(), 26),
                        length("arc-radius", "M", "end", 0)};
    return panel;
}

}  // namespace

std::vector<FigurePanel> slider_crank_figure(const Shared& mechanism) {
    return {links(mechanism), placement(mechanism), function(mechanism), line(mechanism), arc(mechanism)};
}

}  // namespace mechwright
