#include <cmath>
#include <numbers>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/figure/panels.h"
#include "synthesis/mechanism/drawing/motion_row.h"

namespace mechwright {

namespace {

using namespace figure;

constexpr double degree = std::numbers::pi / 180;

/// A degree of the cam is drawn as one; lifts are drawn this high.
constexpr double height = 110;

/// From the origin, with a small head.
Outline axis(const Vector<double>& direction, double length) {
    const Vector<double> tip = length * direction, back = -8.0 * direction, aside = 3.0 * left_of(direction);
    return {Layer::ground, {{{0, 0}, 0}, {tip, 0}, {tip + back + aside, 0}, {tip, 0}, {tip + back - aside, 0}}, false};
}

Outline curve(const MovingDesign& cam, double lift_scale) {
    constexpr int steps = 180;
    Outline outline{Layer::path, {}, false};
    for (int i = 0; i <= steps; ++i) {
        const double angle = 360.0 * i / steps;
        outline.vertices.push_back({{angle, lift_scale * MotionRow(cam, angle * degree)["lift"]}, 0});
    }
    return outline;
}

}  // namespace

FigurePanel cam_motion_panel(const MovingDesign& cam) {
    const bool oscillating = cam_kind(*cam.mechanism).oscillating;
    const double lift_scale = height / cam["lift-1"];
    FigurePanel panel{.title = oscillating ? "The motion of an oscillating follower: [[segment]]"
                                           : "The motion of a translating follower: [[segment]]",
                      .design = cam};
    panel.shows_bodies = false;
    panel.lines = {{axis({1, 0}, 390), "cam angle"},
                   {axis({0, 1}, height + 40), oscillating ? "turn" : "lift"},
                   {curve(cam, lift_scale)}};
    double end = 0;
    panel.places = {fixed("start", {0, 0})};
    std::string last = "start";
    for (const char* number : {"1", "2", "3", "4"}) {
        end += cam[std::string("angle-") + number] / degree;
        const std::string name = std::string("end-") + number;
        panel.places.push_back(fixed(name, {end, 0}));
        panel.dimensions.push_back(length(std::string("angle-") + number, last, name, -26));
        panel.dimensions.back().unit = degree;
        last = name;
    }
    panel.places.push_back(fixed("top", {cam["angle-1"] / degree, lift_scale * cam["lift-1"]}));
    const double falls = (cam["angle-1"] + cam["angle-2"]) / degree;
    panel.places.push_back(fixed("fall", {falls, lift_scale * cam["lift-3"]}));
    panel.places.push_back(fixed("foot", {falls, 0}));
    for (FigureDimension lift : {by("end-1", length_along("lift-1", "start", "top", y_axis(), 30)),
                                 by("foot", length_along("lift-3", "foot", "fall", y_axis(), -62))}) {
        lift.unit = 1 / lift_scale;
        panel.dimensions.push_back(lift);
    }
    panel.remark =
        "lift-2 and lift-4 are none: these segments are dwells. coefficient-1, coefficient-2, ... are the numbers of "
        "polynomials and splines, in the order of the segments.";
    return panel;
}

}  // namespace mechwright
