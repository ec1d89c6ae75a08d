#pragma once
/// \file
/// A panel of a figure laid out: where its mechanism, its dimensions and their names are, in pixels.

#include <cmath>
#include <string>
#include <vector>

#include "synthesis/mechanism/drawing/figure.h"
#include "synthesis/report/drawing/figure/labels.h"
#include "synthesis/report/drawing/svg.h"

namespace mechwright {

/// An arc in the picture; angles are those of the drawing, against the clock.
struct FigureArc {
    Vector<double> vertex;
    double radius = 0;
    double zero = 0;
    double turn = 0;

    Vector<double> at(double angle) const {
        return vertex + radius * Vector<double>{std::cos(angle), -std::sin(angle)};
    }
};

struct DrawnDimension {
    FigureDimension of;
    Vector<double> from{}, to{};  ///< the ends of its line, or of its arc
    Vector<double> along{};       ///< of a line: the direction that counts as positive, a unit vector
    FigureArc arc{};              ///< of an angle
    std::vector<Stroke> zero{};   ///< the line that an angle counts from
    std::vector<Stroke> thin{};   ///< from the places that it is measured at
    TextBox label{};
};

struct PanelLayout {
    Scene scene;
    SvgView view;
    std::vector<BodyPlace> places, end_places;  ///< of the bodies; the second empty where they are drawn once
    std::vector<DrawnDimension> dimensions;
    std::vector<Outline> lines;  ///< in the drawing: what belongs to no body
    std::vector<TextBox> texts;  ///< letters of places and names of links and lines
    std::vector<std::string> title, remark;
    double height = 0;
};

/// The panel in a picture of a width.
PanelLayout lay_out(const FigurePanel& panel, double width);

inline constexpr double figure_line_height = 16;

}  // namespace mechwright
