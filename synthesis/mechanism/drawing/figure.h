#pragma once
/// \file
/// The figure that shows where a mechanism's dimensions are, as plain data: what is drawn, which places have letters,
/// and between which of them each dimension lies. `report` draws it.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "synthesis/mechanism/drawing/moving_design.h"

namespace mechwright {

/// How a place of a figure is found in the drawing.
enum class PlaceOf {
    pin,         ///< of a body
    point,       ///< that a body guides
    corner,      ///< of an outline of a body
    pivot,       ///< on the ground
    fixed,       ///< in the frame of a body, or in the drawing
    line_foot,   ///< the place of the line to be followed that is nearest to the drawing's origin
    line_end,    ///< where that line ends, seen along its direction
    arc_centre,  ///< the centre of the arc to be followed
    arc_end      ///< where that arc ends
};

struct FigurePlace {
    std::string name;
    PlaceOf of = PlaceOf::fixed;
    std::string body{};                                ///< empty: the ground
    std::size_t number = 0;                            ///< of the pin, point, outline or pivot
    std::size_t corner = 0;                            ///< of the outline
    Vector<double> at{};                               ///< of a fixed place
    bool at_end = false;                               ///< with the mechanism at FigurePanel::end
    bool is_shown = name[0] >= 'A' && name[0] <= 'Z';  ///< its name stands beside it
};

/// A direction from one place to another, turned by degrees; without places from the drawing's x axis.
struct FigureSide {
    std::string from{}, to{};
    double turned = 0;
};

/// What a dimension is drawn as.
enum class ShownAs {
    length,      ///< a line with a head at both ends
    coordinate,  ///< a line with a head where it ends; its number is positive that way
    angle,       ///< an arc from the zero line, with a head where it ends
    word         ///< nothing that could be measured: its name beside a place
};

struct FigureDimension {
    std::string name;
    ShownAs as = ShownAs::length;
    std::string from{}, to{};  ///< of an angle the first one is its vertex
    FigureSide along{};        ///< what is measured along; of an angle the zero line
    FigureSide side{};         ///< of an angle: up to where it goes
    double away = 0;           ///< of an angle its radius, else from `by` to its line, to the left; pixels
    std::string by{};          ///< empty: its first place
    double unit = 1;           ///< of a diagram: the dimension over the length that is drawn
};

/// A line of a figure that belongs to no body. `name` stands beside its end.
struct FigureLine {
    Outline outline;
    std::string name{};
};

/// One picture of the figure.
struct FigurePanel {
    std::string title;
    MovingDesign design;
    double input = 0;             ///< at which it is drawn
    std::optional<double> end{};  ///< a second input at which it is drawn, faintly
    std::vector<FigurePlace> places{};
    std::vector<FigureDimension> dimensions{};
    std::vector<FigureLine> lines{};
    std::string remark{};      ///< stands below
    bool shows_bodies = true;  ///< else the lines alone: a diagram
    bool shows_paths = false;  ///< what guided points describe
    bool names_links = true;   ///< those whose name is no dimension of the panel
};

/// A design of a mechanism from its dimensions by their names, angles in degrees; all others are 0.
MovingDesign figure_design(const std::shared_ptr<const Mechanism>& mechanism,
                           const std::vector<std::pair<std::string_view, double>>& dimensions,
                           std::size_t assembly = 0);

/// The panels of all mechanisms of a name, each once: every kind of cam is a mechanism of its own.
std::vector<FigurePanel> figure_of(std::string_view mechanism_name);

/// Those of one mechanism that show a dimension which it has: a problem has the numbers of its own targets alone.
std::vector<FigurePanel> figure_of(const Mechanism& mechanism);

namespace figure {

inline FigurePlace pin(std::string name, std::string body, std::size_t number) {
    return {std::move(name), PlaceOf::pin, std::move(body), number};
}
inline FigurePlace point(std::string name, std::string body) {
    return {std::move(name), PlaceOf::point, std::move(body)};
}
inline FigurePlace corner(std::string name, std::string body, std::size_t outline, std::size_t number) {
    return {std::move(name), PlaceOf::corner, std::move(body), outline, number};
}
inline FigurePlace pivot(std::string name, std::size_t number) { return {std::move(name), PlaceOf::pivot, {}, number}; }
inline FigurePlace fixed(std::string name, const Vector<double>& at, std::string body = {}) {
    return {std::move(name), PlaceOf::fixed, std::move(body), 0, 0, at};
}
/// The drawing's origin, with its axes.
inline FigurePlace origin() { return fixed("O", {0, 0}); }
inline FigurePlace of_target(std::string name, PlaceOf of) { return {std::move(name), of}; }
inline FigurePlace at_end(FigurePlace place) {
    place.at_end = true;
    return place;
}

inline FigureSide side(std::string from, std::string to, double turned = 0) {
    return {std::move(from), std::move(to), turned};
}
inline FigureSide x_axis() { return {}; }
inline FigureSide y_axis() { return {{}, {}, 90}; }

inline FigureDimension length(std::string name, const std::string& from, const std::string& to, double away) {
    return {std::move(name), ShownAs::length, from, to, side(from, to), {}, away};
}
/// Of a length that is measured along something else than the line through its places.
inline FigureDimension length_along(std::string name, std::string from, std::string to, FigureSide along, double away) {
    return {std::move(name), ShownAs::length, std::move(from), std::move(to), std::move(along), {}, away};
}
inline FigureDimension coordinate(std::string name, std::string from, std::string to, FigureSide along, double away) {
    return {std::move(name), ShownAs::coordinate, std::move(from), std::move(to), std::move(along), {}, away};
}
inline FigureDimension angle(std::string name, std::string vertex, FigureSide zero, FigureSide to, double radius) {
    return {std::move(name), ShownAs::angle, std::move(vertex), {}, std::move(zero), std::move(to), radius};
}
/// With its line counted from a place that is none of its ends.
inline FigureDimension by(std::string place, FigureDimension dimension) {
    dimension.by = std::move(place);
    return dimension;
}
inline FigureDimension word(std::string name, std::string place) {
    return {std::move(name), ShownAs::word, std::move(place)};
}

}  // namespace figure

}  // namespace mechwright
