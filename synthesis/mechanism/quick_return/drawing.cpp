#include "synthesis/mechanism/quick_return/drawing.h"

#include "analysis/quick_return.h"
#include "analysis/slider_crank.h"
#include "synthesis/mechanism/drawing/moving_design.h"
#include "synthesis/mechanism/drawing/outlines.h"
#include "synthesis/mechanism/quick_return/drive.h"

namespace mechwright {

namespace {

using quick_return::drive_of;

Vector<double> unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

Body bar(const char* name, double length) {
    return {name, {outlines::segment({0, 0}, {length, 0})}, {{0, 0}, {length, 0}}, {}};
}

Body ram(double symbol) { return {"ram", {outlines::rectangle(1.6 * symbol, symbol, Layer::block)}, {{0, 0}}, {}}; }

/// A block in the slot of an arm.
Body block(double symbol) {
    return {"block", {outlines::rectangle(1.2 * symbol, 0.8 * symbol, Layer::block)}, {{0, 0}}, {}};
}

/// The two edges of a slot along the x axis.
void add_slot(Body& body, double from, double to, double half_width) {
    for (const double side : {-half_width, half_width})
        body.outlines.push_back(outlines::segment({from, side}, {to, side}));
}

template <template <class> class Drive>
std::vector<double> limits(const MovingDesign& design) {
    if (design.motion.family != quick_return::full_turn) return ends_of(design.motion);
    const auto at = ram_limits(drive_of<Drive>(design.dimensions, design.motion.assembly));
    return {at.outer.crank_angle, at.inner.crank_angle};
}

/// Arm or crank, rod and ram of a slider-crank in the frame of its slide: places of rod and ram.
void place_output(const SliderCrank<double>& m, const SliderCrankPose<double>& p, const BodyPlace& frame,
                  BodyPlace& rod, BodyPlace& ram) {
    rod = {in_drawing(frame, m.crank * p.crank), turned(p.rod, frame.turn)};
    ram = {in_drawing(frame, {p.position, m.offset}), frame.turn};
}

namespace slider_crank {

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

}  // namespace slider_crank

/// Drives with a slotted arm. Bodies: crank, block, arm, rod, ram. `centres` is the frame whose x axis is the line of
/// centres from arm pivot to crank pivot, `slide` that of the slide.
template <template <class> class Drive>
bool place_slotted(const MovingDesign& design, double crank_angle, const BodyPlace& centres, const BodyPlace& slide,
                   std::span<BodyPlace> places) {
    const auto m = drive_of<Drive>(design.dimensions, 0);
    const auto p = pose_at(m, crank_angle);
    const Vector<double> arm = turned(p.input.arm, centres.turn);
    places[0] = {in_drawing(centres, {m.centre_distance, 0}), turned(p.input.crank, centres.turn)};
    places[1] = {in_drawing(centres, p.input.reach * p.input.arm), arm};
    places[2] = {centres.at, arm};
    place_output(output_of(m), p.output, slide, places[3], places[4]);
    return p.output.assembled();
}

template <BodyPlace (*centres)(const MovingDesign&)>
std::vector<Vector<double>> slotted_pivots(const MovingDesign& design) {
    return {in_drawing(centres(design), {design["centre-distance"], 0}), {0, 0}};
}

namespace crank_shaper {

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

}  // namespace crank_shaper

namespace whitworth {

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

}  // namespace whitworth

namespace drag_link {

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

}  // namespace drag_link

}  // namespace

Drawing slider_crank_drawing() {
    return {slider_crank::bodies, slider_crank::place, slider_crank::pivots, limits<SliderCrank>};
}

Drawing crank_shaper_drawing() {
    return {crank_shaper::bodies, crank_shaper::place, slotted_pivots<crank_shaper::centres>, limits<CrankShaper>};
}

Drawing whitworth_drawing() {
    return {whitworth::bodies, whitworth::place, slotted_pivots<whitworth::centres>, limits<Whitworth>};
}

Drawing drag_link_drawing() { return {drag_link::bodies, drag_link::place, drag_link::pivots, limits<DragLink>}; }

}  // namespace mechwright
