#pragma once
/// \file
/// A motion over a given range of crank angles.

#include <algorithm>
#include <span>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The motion over the range, radians.
inline Motion over_range(Motion motion, const Vector<Digits50>& range) {
    motion.full_turn = false;
    motion.from = range.x.convert_to<double>();
    motion.to = range.y.convert_to<double>();
    return motion;
}

/// The motion where it stays within an input range, by start and range; else over that range alone. What a target asks
/// for over its input range is measured there, however much further the motion goes.
inline Motion within_input(const Motion& motion, std::span<const Digits50> start_and_range) {
    const Digits50 start = start_and_range[0], end = start + start_and_range[1];
    const Motion over = over_range(motion, {std::min(start, end), std::max(start, end)});
    return !motion.full_turn && motion.from >= over.from && motion.to <= over.to ? motion : over;
}

}  // namespace mechwright
