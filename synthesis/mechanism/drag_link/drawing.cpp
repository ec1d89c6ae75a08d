#include "synthesis/mechanism/quick_return/drawing.h"

#include "synthesis/mechanism/drag_link/drag_link.h"
#include "synthesis/mechanism/drag_link/layout.h"

namespace mechwright {

namespace {

using namespace quick_return;

/// The frame of the four-bar: the follower pivot is the origin of the drawing, the slide lies along the x axis.
BodyPlace links_of(const MovingDesign& design) {
    const Vector<double> turn = unit(-design["slide-angle"]);
    return {turned(Vector<double>{-design["ground"], 0}, turn), turn};
}

std::vector<Body> bodies(const MovingDesign& design, double symbol, double) {
    const Vector<double> arm = design["arm"] * unit(design["arm-angle"]);
    const Vector<double> pin{design["follower"], 0};
    const Body follower{"follower", {outlines::polygon({{0, 0}, pin, arm})}, {{0, 0}, pin, arm}, {}};
    return {bar("crank", design["crank"]), bar("coupler", design["coupler"]), follower, bar("rod", design["rod"]),
            ram(symbol)};
}

bool place(const MovingDesign& design, double crank_angle, std::size_t assembly, std::span<BodyPlace> places) {
    const auto m = drive_of<DragLink>(design.dimensions, assembly);
    const auto p = pose_at(m, crank_angle);
    const BodyPlace links = links_of(design);
    places[0] = {links.at, turned(p.input.crank, links.turn)};
    places[1] = {in_drawing(links, m.links.crank * p.input.crank), turned(p.input.coupler, links.turn)};
    places[2] = {{0, 0}, turned(p.input.rocker, links.turn)};
    place_output(output_of(m), p.output, {}, places[3], places[4]);
    return p.input.assembled() && p.output.assembled();
}

std::vector<Vector<double>> pivots(const MovingDesign& design) { return {links_of(design).at, {0, 0}}; }

}  // namespace

Drawing drag_link_drawing() { return {bodies, place, pivots, limits<DragLink>, nullptr, drag_link_figure}; }

}  // namespace mechwright
