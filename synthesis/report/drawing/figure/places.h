#pragma once
/// \file
/// Where the places of a figure are in the drawing.

#include <span>

#include "synthesis/mechanism/drawing/figure.h"
#include "synthesis/report/drawing/scene.h"

namespace mechwright {

/// A panel's mechanism where it is drawn.
struct PosedPanel {
    const FigurePanel& panel;
    const Scene& scene;
    std::span<const BodyPlace> places, end_places;

    /// In the drawing.
    Vector<double> at(const FigurePlace& place) const;
    Vector<double> at(std::string_view name) const;
    /// A unit vector.
    Vector<double> direction(const FigureSide& side) const;
};

}  // namespace mechwright
