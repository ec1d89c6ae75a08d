#pragma once
/// \file
/// What the drawings of mechanisms that drive a ram have in common.

#include "analysis/quick_return.h"
#include "analysis/slider_crank.h"
#include "synthesis/mechanism/drawing/moving_design.h"
#include "synthesis/mechanism/drawing/outlines.h"
#include "synthesis/mechanism/quick_return/drive.h"

namespace mechwright::quick_return {

inline Vector<double> unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

inline Body bar(const char* name, double length) {
    return {name, {outlines::segment({0, 0}, {length, 0})}, {{0, 0}, {length, 0}}, {}};
}

inline Body ram(double symbol) {
    return {"ram", {outlines::rectangle(1.6 * symbol, symbol, Layer::block)}, {{0, 0}}, {}};
}

template <template <class> class Drive>
std::vector<double> limits(const MovingDesign& design) {
    if (design.motion.family != quick_return::full_turn) return ends_of(design.motion);
    const auto at = ram_limits(drive_of<Drive>(design.dimensions, design.motion.assembly));
    return {at.outer.crank_angle, at.inner.crank_angle};
}

/// Arm or crank, rod and ram of a slider-crank in the frame of its slide: places of rod and ram.
inline void place_output(const SliderCrank<double>& m, const SliderCrankPose<double>& p, const BodyPlace& frame,
                         BodyPlace& rod, BodyPlace& ram) {
    rod = {in_drawing(frame, m.crank * p.crank), turned(p.rod, frame.turn)};
    ram = {in_drawing(frame, {p.position, m.offset}), frame.turn};
}

}  // namespace mechwright::quick_return
