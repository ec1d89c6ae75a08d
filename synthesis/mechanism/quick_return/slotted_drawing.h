#pragma once
/// \file
/// What the drawings of drives with a slotted arm have in common.

#include "synthesis/mechanism/quick_return/drawing.h"

namespace mechwright::quick_return {

/// A block in the slot of an arm.
inline Body block(double symbol) {
    return {"block", {outlines::rectangle(1.2 * symbol, 0.8 * symbol, Layer::block)}, {{0, 0}}, {}};
}

/// The two edges of a slot along the x axis.
inline void add_slot(Body& body, double from, double to, double half_width) {
    for (const double side : {-half_width, half_width})
        body.outlines.push_back(outlines::segment({from, side}, {to, side}));
}

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

}  // namespace mechwright::quick_return
