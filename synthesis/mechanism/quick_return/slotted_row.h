#pragma once
/// \file
/// The motion table of the drives with a slotted arm, for unit crank speed.

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "analysis/four_bar/exact_turn.h"
#include "synthesis/mechanism/quick_return/drive.h"

namespace mechwright::quick_return {

/// The block's pressure angle is that seen from the crank, between crank pin velocity and push on the arm; arm angles
/// are counted from the line of centres to the slot.
inline std::vector<std::string> slotted_columns() {
    return {"crank-angle",  "arm-angle",        "rod-angle",      "transmission-angle", "block-pressure-angle",
            "arm-velocity", "arm-acceleration", "block-position", "block-velocity",     "coriolis-acceleration",
            "rod-velocity", "ram-position",     "ram-velocity",   "ram-acceleration"};
}

inline std::vector<Unit> slotted_units() {
    return {Unit::angle,  Unit::angle,  Unit::angle,  Unit::angle, Unit::angle,  Unit::none,   Unit::none,
            Unit::length, Unit::length, Unit::length, Unit::none,  Unit::length, Unit::length, Unit::length};
}

template <template <class> class Drive>
bool slotted_row(const Motion& motion, std::span<const double> dimensions, double crank_angle, std::span<double> row) {
    const Drive<double> m = drive_of<Drive>(dimensions, motion.assembly);
    const auto p = pose(m, exact_half_turn(crank_angle));
    if (!p.output.assembled()) return false;
    const auto v = velocity(m, p);
    const auto a = acceleration(m, p, v);
    const std::array<double, 14> values{crank_angle,
                                        std::atan2(p.input.arm.y, p.input.arm.x),
                                        std::atan2(p.output.rod.y, p.output.rod.x),
                                        transmission_angle(p.output),
                                        block_pressure_angle(p.input),
                                        v.input.arm,
                                        a.input.arm,
                                        p.input.reach,
                                        v.input.slide,
                                        a.input.coriolis,
                                        v.output.rod,
                                        p.output.position,
                                        v.output.ram,
                                        a.output.ram};
    std::copy(values.begin(), values.end(), row.begin());
    return true;
}

}  // namespace mechwright::quick_return
