#include "synthesis/mechanism/four_bar/drawing.h"

#include "analysis/four_bar.h"
#include "analysis/geometry/placement.h"
#include "synthesis/mechanism/drawing/moving_design.h"
#include "synthesis/mechanism/drawing/outlines.h"
#include "synthesis/mechanism/four_bar/figure.h"

namespace mechwright {

namespace {

FourBar<double> linkage_of(const MovingDesign& design) {
    return {design["ground"], design["crank"], design["coupler"], design["rocker"]};
}

/// The frame of the linkage in the drawing.
BodyPlace frame_of(const MovingDesign& design) {
    const double tilt = design["tilt"];
    return {{design["origin-x"], design["origin-y"]}, {std::cos(tilt), std::sin(tilt)}};
}

Assembly assembly_of(std::size_t index) { return index == 0 ? Assembly::open : Assembly::crossed; }

/// The coupler with its point: a triangle where the point lies off the line of the pins.
Body coupler_of(const MovingDesign& design, double symbol) {
    const double length = design["coupler"];
    const Vector<double> point{design["point-along"], design["point-across"]};
    Body body{"coupler", {}, {{0, 0}, {length, 0}}, {}};
    const bool guides = design.guides_point;
    if (!guides && point.x == 0 && point.y == 0) {
        body.outlines.push_back(outlines::segment({0, 0}, {length, 0}));
        return body;
    }
    body.points.push_back(point);
    body.outlines.push_back(outlines::polygon({{0, 0}, {length, 0}, point}));
    if (design.guides_body) {
        const double angle = design["body-angle"];
        body.outlines.push_back(outlines::arrow(point, {std::cos(angle), std::sin(angle)}, 3 * symbol, Layer::path));
    }
    return body;
}

std::vector<Body> bodies(const MovingDesign& design, double symbol, double) {
    const auto bar = [&](const char* name) {
        const double length = design[name];
        return Body{name, {outlines::segment({0, 0}, {length, 0})}, {{0, 0}, {length, 0}}, {}};
    };
    return {bar("crank"), coupler_of(design, symbol), bar("rocker")};
}

bool place(const MovingDesign& design, double crank_angle, std::size_t assembly, std::span<BodyPlace> places) {
    const FourBar<double> m = linkage_of(design);
    const auto p = pose(m, crank_angle, assembly_of(assembly));
    const BodyPlace frame = frame_of(design);
    places[0] = {frame.at, turned(p.crank, frame.turn)};
    places[1] = {in_drawing(frame, m.crank * p.crank), turned(p.coupler, frame.turn)};
    places[2] = {in_drawing(frame, {m.ground, 0}), turned(p.rocker, frame.turn)};
    return p.assembled();
}

std::vector<Vector<double>> pivots(const MovingDesign& design) {
    const BodyPlace frame = frame_of(design);
    return {frame.at, in_drawing(frame, {design["ground"], 0})};
}

std::vector<double> limits(const MovingDesign& design) {
    const FourBar<double> m = linkage_of(design);
    if (!design.motion.full_turn) return ends_of(design.motion);
    if (classify(m).kind != FourBarClass::crank_rocker) return {};
    const auto positions = limit_positions(m, assembly_of(design.motion.assembly));
    return {positions.extended.crank_angle, positions.folded.crank_angle};
}

}  // namespace

Drawing four_bar_drawing() { return {bodies, place, pivots, limits, nullptr, four_bar_figure}; }

}  // namespace mechwright
