#include "synthesis/mechanism/quick_return/slotted_drawing.h"
#include "synthesis/mechanism/whitworth/layout.h"
#include "synthesis/mechanism/whitworth/whitworth.h"

namespace mechwright {

namespace {

using namespace quick_return;

/// The slide lies along the x axis.
BodyPlace centres(const MovingDesign& design) { return {{0, 0}, unit(-design["slide-angle"])}; }

std::vector<Body> bodies(const MovingDesign& design, double symbol, double) {
    const double centre = design["centre-distance"], crank = design["crank"], length = design["arm"];
    Body arm{"arm", {outlines::segment({0, 0}, {-length, 0})}, {{0, 0}, {-length, 0}}, {}};
    arm.outlines.push_back(outlines::segment({0, 0}, {crank - centre, 0}));
    add_slot(arm, crank - centre - 2 * symbol, crank + centre + 2 * symbol, symbol);
    return {bar("crank", crank), block(symbol), arm, bar("rod", design["rod"]), ram(symbol)};
}

bool place(const MovingDesign& design, double crank_angle, std::size_t, std::span<BodyPlace> places) {
    return place_slotted<Whitworth>(design, crank_angle, centres(design), {}, places);
}

}  // namespace

Drawing whitworth_drawing() {
    return {bodies, place, slotted_pivots<centres>, limits<Whitworth>, nullptr, whitworth_figure};
}

}  // namespace mechwright
