#include "synthesis/mechanism/crank_shaper/crank_shaper.h"
#include "synthesis/mechanism/crank_shaper/layout.h"
#include "synthesis/mechanism/quick_return/slotted_drawing.h"

namespace mechwright {

namespace {

using namespace quick_return;

/// The line of centres points up; the ram moves out to the left.
BodyPlace centres(const MovingDesign&) { return {{0, 0}, {0, 1}}; }

std::vector<Body> bodies(const MovingDesign& design, double symbol, double) {
    const double lever = design["lever"], centre = design["centre-distance"], crank = design["crank"];
    Body arm = bar("lever", lever);
    add_slot(arm, centre - crank - 2 * symbol, centre + crank + 2 * symbol, symbol);
    return {bar("crank", crank), block(symbol), arm, bar("rod", design["rod"]), ram(symbol)};
}

bool place(const MovingDesign& design, double crank_angle, std::size_t, std::span<BodyPlace> places) {
    return place_slotted<CrankShaper>(design, crank_angle, centres(design), {{0, 0}, {-1, 0}}, places);
}

}  // namespace

Drawing crank_shaper_drawing() {
    return {bodies, place, slotted_pivots<centres>, limits<CrankShaper>, nullptr, crank_shaper_figure};
}

}  // namespace mechwright
