#include "synthesis/mechanism/quick_return/drawing.h"

#include "synthesis/mechanism/slider_crank/layout.h"
#include "synthesis/mechanism/slider_crank/slider_crank.h"

namespace mechwright {

namespace {

using namespace quick_return;

BodyPlace frame_of(const MovingDesign& design) {
    return {{design["origin-x"], design["origin-y"]}, unit(design["tilt"])};
}

std::vector<Body> bodies(const MovingDesign& design, double symbol, double) {
    Body rod = bar("rod", design["rod"]);
    const Vector<double> point{design["point-along"], design["point-across"]};
    if (design.guides_point || point.x != 0 || point.y != 0) {
        rod.points.push_back(point);
        rod.outlines = {outlines::polygon({{0, 0}, {design["rod"], 0}, point})};
        if (design.guides_body)
            rod.outlines.push_back(outlines::arrow(point, unit(design["body-angle"]), 3 * symbol, Layer::path));
    }
    return {bar("crank", design["crank"]), rod, ram(symbol)};
}

bool place(const MovingDesign& design, double crank_angle, std::size_t, std::span<BodyPlace> places) {
    const auto m = drive_of<SliderCrank>(design.dimensions, 0);
    const auto p = pose(m, crank_angle);
    const BodyPlace frame = frame_of(design);
    places[0] = {frame.at, turned(p.crank, frame.turn)};
    place_output(m, p, frame, places[1], places[2]);
    return p.assembled();
}

std::vector<Vector<double>> pivots(const MovingDesign& design) { return {frame_of(design).at}; }

}  // namespace

Drawing slider_crank_drawing() { return {bodies, place, pivots, limits<SliderCrank>, nullptr, slider_crank_figure}; }

}  // namespace mechwright
