#pragma once
/// \file
/// How each mechanism is drawn.

#include "synthesis/report/drawing/scene.h"

namespace mechwright::drawing {

/// What is drawn of a mechanism. `bodies` and `ground` are given the size of symbols.
struct Drawn {
    std::vector<Body> (*bodies)(const FinishedDesign& design, double symbol, double tolerance);
    bool (*place)(const FinishedDesign& design, double crank_angle, std::size_t assembly, std::span<Place> places);
    std::vector<Vector<double>> (*pivots)(const FinishedDesign& design);
    std::vector<double> (*limits)(const FinishedDesign& design);
};

const Drawn& four_bar_drawn();
const Drawn& slider_crank_drawn();
const Drawn& crank_shaper_drawn();
const Drawn& whitworth_drawn();
const Drawn& drag_link_drawn();
const Drawn& cam_drawn();

/// The first and the last crank angle, unless the motion is a full turn.
std::vector<double> ends_of(const Motion& motion);

}  // namespace mechwright::drawing
